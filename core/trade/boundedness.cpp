#include "core/trade/boundedness.h"

#include <algorithm>
#include <cmath>

#include "core/run/run.h"

namespace core {
namespace {

constexpr int kWeightStepsUnasked = 20'000;  // between two questions whether to go on
// Weights at rest have no energy to move with; rounding must not count as running away.
constexpr double kLeastEnergy = 1e-9;  // of the start energy; and at least this much [J]

double lowestHeight(const Scene& scene, const Weight& weight) {
  if (!weight.rope || scene.cutTime) return weight.radius;
  return std::max(weight.radius, weight.rope->pivot.y() - weight.rope->length);
}

}  // namespace

double energyToMoveWith(const Scene& scene) {
  double energy = 0;
  for (const Weight& weight : scene.weights) {
    const double fall = startPosition(weight).y() - lowestHeight(scene, weight);
    energy += 0.5 * weight.mass * startVelocity(weight).squaredNorm();
    energy += weight.mass * scene.gravity * std::max(0.0, fall);
  }
  return energy;
}

std::optional<BoundednessTrial> boundednessOf(const std::shared_ptr<const Scene>& scene,
                                              const Solver& solver, double until,
                                              WorkMeter& meter) {
  Run run(scene, solver);
  const double scale = std::max(
      {energyToMoveWith(*scene), kLeastEnergy * std::abs(run.startEnergy()), kLeastEnergy});
  const int stepsUnasked = std::max(1, kWeightStepsUnasked / (1 + run.weightCount()));
  BoundednessTrial trial;
  for (int step = 1; run.time() < until; ++step) {
    if (step % stepsUnasked == 0 && !meter.add(0)) return std::nullopt;
    if (run.advance() != RunStatus::kRunning) {
      trial.outcome = Boundedness::kDiverged;
      break;
    }
    const double drift = run.energies().numericalDrift / scale;
    trial.drift = std::max(trial.drift, std::abs(drift));
    if (drift > 1) {
      trial.outcome = Boundedness::kRunaway;
      break;
    }
  }
  if (!meter.add(0)) return std::nullopt;
  return trial;
}

}  // namespace core
