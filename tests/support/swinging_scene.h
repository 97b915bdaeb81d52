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

/// Three weights that swing, are cut at 1.5 s, fall and bounce.
inline core::Scene cutSwings() {
  core::Scene scene = swingingScene(3, 0.3);
  scene.cutTime = 1.5;
  return scene;
}

}  // namespace tests
