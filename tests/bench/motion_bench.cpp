// Weights that touch nothing, by Runge–Kutta 4: nanoseconds of computing per weight and step, for
// steps alone (BatchStepper) and for whole steps of a run, which look for events as well.
//
//     motion_bench

#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "core/run/batch_stepper.h"
#include "core/run/run.h"
#include "tests/support/processor_time.h"

using core::Scene;

namespace {

constexpr double kStep = 1.0 / 240;
constexpr int kWeightSteps = 2'000'000;

/// Weights on ropes, or in flight, far from walls and each other.
std::shared_ptr<const Scene> loneWeights(int count, bool onRopes) {
  constexpr double kCell = 2;
  auto scene = std::make_shared<Scene>();
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  const double size = columns * kCell;
  scene->room = {.width = size, .height = size + 100};
  // Nobody falls to the floor while it is measured.
  scene->gravity = onRopes ? 9.81 : 1e-6;
  for (int i = 0; i < count; ++i) {
    core::Weight weight;
    const int row = i / columns;
    const Eigen::Vector2d place((i % columns + 0.5) * kCell, (row + 0.5) * kCell + 50);
    weight.position = place;
    weight.velocity = {1e-3, 1e-3};
    if (onRopes) weight.rope = core::Rope{.pivot = place, .length = 0.5, .angle = 1};
    scene->weights.push_back(weight);
  }
  return scene;
}

/// @return  [ns] per weight and step
double ofRuns(int count, bool onRopes) {
  core::Run run(loneWeights(count, onRopes), {.step = kStep});
  run.advance();
  const int steps = std::max(1, kWeightSteps / count);
  const double start = tests::processorTime();
  for (int i = 0; i < steps; ++i) run.advance();
  return (tests::processorTime() - start) * 1e9 / steps / count;
}

/// @return  [ns] per weight and step
double ofSteps(int count, bool onRopes) {
  const auto scene = loneWeights(count, onRopes);
  const std::vector<core::Body> bodies = core::bodiesOf(*scene);
  std::vector<core::Piece> pieces(bodies.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pieces[i].end = kStep;
    pieces[i].mode = onRopes ? core::Mode::kSwing : core::Mode::kFlight;
    pieces[i].beginState << 1, 1, 0.5, 0.5, 0;
  }
  core::BatchStepper stepper(*core::findMethod("rk4"), scene->gravity);
  const int rounds = std::max(1, kWeightSteps / count);
  const double start = tests::processorTime();
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < pieces.size(); ++i) stepper.add(bodies[i], pieces[i]);
    stepper.finish();
  }
  return (tests::processorTime() - start) * 1e9 / rounds / count;
}

}  // namespace

int main() {
  std::printf("%8s %14s %14s %14s %14s\n", "weights", "flight, step", "flight, run", "rope, step",
              "rope, run");
  for (const int count : {1, 10, 100, 1000, 10000, 100000})
    std::printf("%8d %14.1f %14.1f %14.1f %14.1f\n", count, ofSteps(count, false),
                ofRuns(count, false), ofSteps(count, true), ofRuns(count, true));
}
