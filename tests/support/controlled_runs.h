#pragma once

#include <memory>
#include <vector>

#include "core/scene/scene.h"
#include "tests/support/fingerprint.h"
#include "ui/control/run_controller.h"

namespace tests {

/// A stopwatch on which every look takes this long [s].
inline ui::RunController::Stopwatch ticking(double perLook) {
  return [perLook, now = 0.0]() mutable { return now += perLook; };
}

/// A light ball shot into thick air: Euler's step is far too large for the drag and diverges
/// within a tenth of a second, Runge–Kutta's is not.
inline std::shared_ptr<core::Scene> lightBallInThickAir() {
  auto scene = std::make_shared<core::Scene>();
  scene->airDensity = 30;
  scene->room.width = 1000;
  core::Weight ball;
  ball.mass = 1e-3;
  ball.position = {1, 1};
  ball.velocity = {100, 0};
  scene->weights = {ball};
  scene->solvers = {{.method = "euler", .step = 0.05}, {.method = "rk4", .step = 1e-3}};
  return scene;
}

/// How all runs stand after their latest steps, and all that is recorded, to be compared bit for
/// bit.
inline std::vector<double> recordedBits(const ui::RunController& controller) {
  std::vector<double> bits;
  for (int i = 0; i < controller.runCount(); ++i) {
    const std::vector<double> latest = fingerprint(controller.run(i));
    bits.insert(bits.end(), latest.begin(), latest.end());
    for (const core::EnergySample& sample : controller.recording(i).ledger().samples())
      bits.insert(bits.end(), {sample.time, sample.energies.kinetic, sample.energies.accounted()});
    for (const core::Event& event : controller.recording(i).eventLog().events())
      bits.insert(bits.end(), {event.time, static_cast<double>(event.kind), event.energyLost});
  }
  return bits;
}

}  // namespace tests
