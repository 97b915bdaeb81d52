#pragma once

#include <optional>

namespace core {

/// Where the energy of a scene is and went, all in [J].
struct Energies {
  double kinetic = 0;
  double potential = 0;       ///< m g y of the centers, zero on the floor
  double lostToAir = 0;       ///< integrated with the same method as the motion
  double lostToImpacts = 0;   ///< including what friction takes during an impact
  double lostToRopes = 0;     ///< jerks of ropes that go taut
  double lostToFriction = 0;  ///< sliding at rest on a surface
  double numericalDrift = 0;  ///< what the method got wrong: sum of all above − start energy

  /// Kinetic + potential: what is left to move with.
  double mechanical() const { return kinetic + potential; }

  /// Everything but the drift: would equal the start energy if the method were exact.
  double accounted() const {
    return kinetic + potential + lostToAir + lostToImpacts + lostToRopes + lostToFriction;
  }

  /// Drift as a share of the energy at the start [-]; nothing where that was zero.
  std::optional<double> driftShare() const {
    const double start = accounted() - numericalDrift;
    if (start == 0) return std::nullopt;
    return numericalDrift / start;
  }
};

}  // namespace core
