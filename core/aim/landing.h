#pragma once

#include <cstdint>

namespace core {

/// How the wait for a landing ended.
enum class LandingOutcome : std::uint8_t {
  kLanded,
  kNotInTime,  ///< it did not come to the floor as long as one waited
  kStopped,    ///< the run could not go on, see RunStatus
};

/// What a weight hit first on its way from the cut to the floor.
enum class FirstHit : std::uint8_t { kNothing, kWall, kWeight };

/// Where a weight comes to the floor for the first time after all ropes are cut.
struct Landing {
  double cutTime = 0;  ///< [s]
  LandingOutcome outcome = LandingOutcome::kNotInTime;
  double place = 0;  ///< x of the center [m]; only where it landed
  double time = 0;   ///< of the landing [s]; only where it landed
  FirstHit firstHit = FirstHit::kNothing;
  /// Stands for everything that was hit, before and after the cut, in its order, as far as it
  /// can have mattered to this landing. Between two cut times with the same history the place
  /// changes smoothly; with another one it may jump.
  std::uint64_t history = 0;
};

/// Both landed after the same history, or both did not land for the same reason.
inline bool areAlike(const Landing& a, const Landing& b) {
  if (a.outcome != b.outcome) return false;
  return a.outcome != LandingOutcome::kLanded || a.history == b.history;
}

}  // namespace core
