#pragma once

#include "core/scene/arrangement.h"
#include "core/scene/scene.h"

namespace tests {

/// Weights on ropes that are let go at an angle [rad], under Runge–Kutta 4 and Euler.
inline core::Scene swingingScene(int count = 3, double angle = 0.5) {
  core::Scene scene = core::withWeightCount(core::Scene(), count);
  for (core::Weight& weight : scene.weights)
    if (weight.rope) weight.rope->angle = angle;
  scene.name = "Some that swing";
  scene.solvers = {{.method = "rk4"}, {.method = "euler"}};
  return scene;
}

}  // namespace tests
