#include "tests/support/random_scene.h"

#include <cmath>
#include <random>

#include "core/scene/scene_limits.h"

namespace tests {
namespace {

class Dice {
 public:
  explicit Dice(std::uint32_t seed) : m_random(seed) {}

  bool chance(double share) { return between(0, 1) < share; }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(m_random()) / 0x1p32;
  }
  double onLogScale(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
  }
  Eigen::Vector2d pairUpTo(double x, double y) {
    const double first = between(0, x);
    return {first, between(0, y)};
  }

 private:
  std::mt19937 m_random;
};

core::Weight randomWeight(Dice& dice, const core::Room& room) {
  core::Weight weight;
  weight.mass = dice.onLogScale(0.003, 3);
  weight.radius = dice.onLogScale(0.005, 0.1);
  if (dice.chance(0.5)) {
    weight.rope = core::Rope{.pivot = dice.pairUpTo(room.width, room.height),
                             .length = dice.between(0.1, 1),
                             .angle = dice.between(-3, 3),
                             .angularVelocity = dice.between(-6, 6),
                             .rigid = dice.chance(0.3)};
  } else {
    weight.position = dice.pairUpTo(room.width, room.height);
    weight.velocity = dice.pairUpTo(8, 8) - Eigen::Vector2d(4, 4);
  }
  return weight;
}

}  // namespace

core::Scene randomScene(std::uint32_t seed, int weights) {
  constexpr int kTries = 50;
  Dice dice(seed);
  core::Scene scene;
  scene.gravity = dice.chance(0.8) ? dice.between(1, 20) : 0;
  scene.airDensity = dice.chance(0.7) ? 1.2 : 0;
  scene.room = {.width = dice.between(1, 3),
                .height = dice.between(1, 2),
                .restitution = dice.between(0.3, 1),
                .friction = dice.chance(0.5) ? dice.between(0, 0.5) : 0};
  scene.restitution = dice.between(0.3, 1);
  if (dice.chance(0.7)) scene.cutTime = dice.between(0, 1);
  for (int tries = kTries * weights; tries > 0; --tries) {
    if (static_cast<int>(scene.weights.size()) == weights) break;
    scene.weights.push_back(randomWeight(dice, scene.room));
    if (!core::problemsIn(scene).empty()) scene.weights.pop_back();
  }
  return scene;
}

}  // namespace tests
