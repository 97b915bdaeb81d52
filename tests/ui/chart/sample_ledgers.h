#pragma once

#include <cmath>
#include <numbers>

#include "core/recording/ledger.h"

/// Ledgers with known contents, in closed form.
namespace sample_ledgers {

inline core::EnergySample sampleAt(double time, const core::Energies& energies) {
  return {time, energies};
}

/// Energy that swings between kinetic and potential once a second.
///
/// @param until    [s]
/// @param samples  ≥ 2, evenly spaced from 0 to `until`
/// @param height   potential energy of the lowest point [J]
/// @param gain     numerical drift per second, all in kinetic energy [J/s]
inline core::Ledger swinging(double until, int samples, double height = 1, double gain = 0) {
  core::Ledger ledger;
  for (int i = 0; i < samples; ++i) {
    const double time = until * i / (samples - 1);
    const double part = std::pow(std::sin(std::numbers::pi * time), 2);
    core::Energies energies;
    energies.kinetic = 2 * part + gain * time;
    energies.potential = height + 2 * (1 - part);
    energies.numericalDrift = gain * time;
    ledger.append(sampleAt(time, energies));
  }
  return ledger;
}

/// Begins with 3 J and doubles each second until doubles end.
inline core::Ledger diverging() {
  core::Ledger ledger;
  for (int i = 0; i <= 1020; ++i) {
    core::Energies energies;
    energies.kinetic = 2 * std::exp2(i);
    energies.potential = 1;
    energies.numericalDrift = energies.accounted() - 3;
    ledger.append(sampleAt(i, energies));
  }
  return ledger;
}

}  // namespace sample_ledgers
