#pragma once

#include <cstddef>
#include <string>

#include "core/run/run.h"

namespace tests {

/// How exactly a run must keep its weights where they may be.
struct Bounds {
  double outside = 1e-6;    ///< how far a disc may reach into a wall [m]
  double outsideShare = 0;  ///< the same, as a share of its radius; added
  double overlap = 1e-6;    ///< how far two discs may reach into each other [m]
  double overlapShare = 0;  ///< the same, as a share of their radii; the larger one counts
  double travelShare = 0;   ///< what rounding may leave of the longest way of a step; added to both
  bool looksInside = true;  ///< whether moments inside steps are looked at, too

  /// For weights, rooms and speeds as they are in a classroom.
  static Bounds ordinary() { return {}; }
  /// For anything a scene file allows: one of 10⁹ kg may lie on one of 10⁻⁶ kg, and places in the
  /// largest rooms are rounded to 10⁻¹¹ m.
  static Bounds extreme(const core::Room& room);
};

/// How far the discs reach into walls at most, now [m], but for the share of their radii that is
/// allowed; negative where none does.
double farthestOutside(const core::Run& run, const Bounds& bounds);
/// How far two discs reach into each other at most, beyond what the bounds allow [m].
double deepestOverlap(const core::Run& run, const Bounds& bounds);
/// Whether every number that the run shows now is finite.
bool isFinite(const core::Run& run);

/// Looks after every step whether a run keeps what every run must: finite numbers, discs in the
/// room and apart, a ledger that closes, losses that never shrink, events in order.
class RunWatch {
 public:
  /// @param run  before its first step
  RunWatch(const core::Run& run, const Bounds& bounds);

  /// @return  what is wrong after the latest step, in words; empty if nothing is
  std::string faultAfterStep(const core::Run& run);

  /// Impacts, cuts and so on listed so far.
  std::size_t eventCount() const { return m_eventCount; }

 private:
  std::string faultInPlaces(const core::Run& run) const;
  double roundingOfPlaces(const core::Run& run) const;
  std::string faultInLedger(const core::Run& run) const;
  std::string faultInEvents(const core::Run& run) const;

  Bounds m_bounds;
  double m_time = 0;  // at the end of the step before [s]
  core::Energies m_energies;
  std::size_t m_eventCount = 0;
  double m_fastest = 0;  // in any event so far [m/s]
};

}  // namespace tests
