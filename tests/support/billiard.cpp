#include "tests/support/billiard.h"

#include <algorithm>
#include <cmath>

namespace tests {
namespace {

constexpr double kSpeed = 1;     // of the heavy disc [m/s]
constexpr double kLight = 0.01;  // mass [kg]

}  // namespace

core::Scene billiard(double massRatio) {
  core::Scene scene;
  scene.gravity = 0;
  scene.airDensity = 0;
  scene.room = {.width = 10, .height = 3, .restitution = 1, .friction = 0};
  scene.weights.resize(2);
  core::Weight& light = scene.weights[0];
  core::Weight& heavy = scene.weights[1];
  light.mass = kLight;
  light.radius = 0.02;
  light.position = {0.5, 1.5};
  heavy.mass = kLight * massRatio;
  heavy.radius = 0.1;
  heavy.position = {1.5, 1.5};
  heavy.velocity = {-kSpeed, 0};
  return scene;
}

double exactBilliardPlace(const core::Scene& scene, double time) {
  // With a and b the free ways of the two to the wall, (√m a, √M b) moves like a point of
  // light between two mirrors at an angle α = atan √(m/M): on a straight line when the
  // mirrored wedges are unfolded next to each other.
  const core::Weight& light = scene.weights[0];
  const core::Weight& heavy = scene.weights[1];
  const long double rootRatio = std::sqrt(static_cast<long double>(light.mass) / heavy.mass);
  const double behind = heavy.radius + 2 * light.radius;
  const long double across = rootRatio * (light.position.x() - light.radius);
  const long double along = heavy.position.x() - behind - kSpeed * time;
  const long double alpha = std::atan(rootRatio);
  const long double folded = std::fmod(std::atan2(across, along), 2 * alpha);
  const long double angle = std::min(folded, 2 * alpha - folded);
  return static_cast<double>(std::hypot(across, along) * std::cos(angle)) + behind;
}

}  // namespace tests
