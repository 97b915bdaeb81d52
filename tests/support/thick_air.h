#pragma once

#include <memory>
#include <numbers>

#include "core/scene/scene.h"

namespace tests {

constexpr double kThickAirSpeed = 30;  ///< [m/s]

/// A weight thrown at v = kThickAirSpeed into air of drag factor q = 1/m, without gravity:
/// v' = −q v². With x = q v h explicit Euler's first step leaves (1 − x)² of the energy and
/// books 2 x as lost, a drift of x²: more than all there was at steps above 1 / (q v). Its
/// speed grows where |1 − x| > 1, at steps above 2 / (q v).
inline std::shared_ptr<const core::Scene> thickAir() {
  core::Scene scene;
  scene.gravity = 0;
  scene.airDensity = 1000;
  scene.room = {.width = 1e5, .height = 1e5, .restitution = 1, .friction = 0};
  scene.weights.resize(1);
  scene.weights[0].mass = 1;
  scene.weights[0].radius = 0.1;
  scene.weights[0].dragCoefficient = 0.2 / std::numbers::pi;
  scene.weights[0].position = {5e4, 5e4};
  scene.weights[0].velocity = {kThickAirSpeed, 0};
  return std::make_shared<const core::Scene>(std::move(scene));
}

}  // namespace tests
