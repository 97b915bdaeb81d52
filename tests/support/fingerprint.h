#pragma once

#include <vector>

#include "core/run/run.h"

namespace tests {

/// Every number a run shows now and about its latest step, to be compared bit for bit.
inline std::vector<double> fingerprint(const core::Run& run) {
  std::vector<double> numbers{run.time(), static_cast<double>(run.slopeEvaluations())};
  for (int i = 0; i < run.weightCount(); ++i) {
    const core::WeightState weight = run.weight(i);
    numbers.insert(numbers.end(), {static_cast<double>(weight.phase), weight.position.x(),
                                   weight.position.y(), weight.velocity.x(), weight.velocity.y(),
                                   weight.angle, weight.angularVelocity, weight.tension});
  }
  const core::Energies energies = run.energies();
  numbers.insert(numbers.end(),
                 {energies.kinetic, energies.potential, energies.lostToAir, energies.lostToImpacts,
                  energies.lostToRopes, energies.lostToFriction, energies.numericalDrift});
  for (const core::Event& event : run.stepEvents())
    numbers.insert(numbers.end(),
                   {event.time, static_cast<double>(event.kind), static_cast<double>(event.weight),
                    event.position.x(), event.position.y(), event.energyLost});
  return numbers;
}

}  // namespace tests
