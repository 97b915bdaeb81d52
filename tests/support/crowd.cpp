#include "tests/support/crowd.h"

#include <cmath>
#include <numbers>
#include <random>

namespace tests {

core::Scene crowd(int count, int columns) {
  constexpr double kPacking = 0.3;
  constexpr double kRadius = 0.02;
  core::Scene scene;
  std::mt19937 generator(1);
  const auto share = [&] { return static_cast<double>(generator()) / 0x1p32; };
  if (columns == 0) columns = static_cast<int>(std::ceil(std::sqrt(count)));
  const double cell = kRadius * std::sqrt(std::numbers::pi / kPacking);
  scene.room = {.width = columns * cell,
                .height = std::ceil(static_cast<double>(count) / columns) * cell,
                .restitution = 0.8};
  scene.restitution = 0.8;
  for (int i = 0; i < count; ++i) {
    const int column = i % columns, row = i / columns;
    core::Weight weight;
    weight.radius = kRadius;
    weight.position = {(column + 0.5) * cell, (row + 0.5) * cell};
    weight.velocity = {share() - 0.5, share() - 0.5};
    scene.weights.push_back(weight);
  }
  return scene;
}

}  // namespace tests
