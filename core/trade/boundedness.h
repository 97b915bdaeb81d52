#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/scene/scene.h"
#include "core/trade/work_meter.h"

namespace core {

/// What becomes of a run with a step that may be too large.
enum class Boundedness : std::uint8_t {
  kBounded,   ///< its drift never grew beyond the energy the scene has to move with
  kRunaway,   ///< it made more energy than that out of nothing
  kDiverged,  ///< its numbers stopped being finite, or its events could not be followed
};

/// How a run stood the test.
struct BoundednessTrial {
  Boundedness outcome = Boundedness::kBounded;
  /// Largest size of the numerical drift, as a share of the energy the scene has to move with,
  /// up to where the trial ended.
  double drift = 0;
};

/// The energy the scene has to move with [J]: kinetic, and potential down to where its weights
/// can fall: to the floor, or where ropes are never cut, to straight below the pivot.
double energyToMoveWith(const Scene& scene);

/// Runs the scene up to `until`, or to where the outcome is plain.
///
/// @param until  [s], ≥ 0
/// @param meter  asked whether to go on; nothing is counted
/// @return       nothing if the meter stopped it
/// @pre as for Run
std::optional<BoundednessTrial> boundednessOf(const std::shared_ptr<const Scene>& scene,
                                              const Solver& solver, double until, WorkMeter& meter);

}  // namespace core
