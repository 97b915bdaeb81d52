#pragma once

#include <memory>

#include "core/scene/scene.h"

namespace tests {

/// Weights that never come to rest in a narrow box, by a step so long that nobody sees its end:
/// hundreds of thousands of impacts, which take many seconds to compute.
inline std::shared_ptr<core::Scene> endlessStep() {
  auto scene = std::make_shared<core::Scene>();
  scene->name = "One long step";
  scene->gravity = 0;
  scene->airDensity = 0;
  scene->room = {.width = 1, .height = 1, .restitution = 1};
  constexpr int kColumns = 20;
  for (int i = 0; i < kColumns * kColumns; ++i) {
    core::Weight weight;
    weight.radius = 0.02;
    const int row = i / kColumns;
    weight.position = {(i % kColumns + 0.5) / kColumns, (row + 0.5) / kColumns};
    weight.velocity = {(i * 7 % 11 - 5) * 10.0, (i * 5 % 13 - 6) * 10.0};
    scene->weights.push_back(weight);
  }
  scene->solvers = {{.method = "rk4", .step = 10}};
  return scene;
}

}  // namespace tests
