#pragma once

#include <memory>

#include "core/scene/scene.h"
#include "core/trade/work_meter.h"

namespace core {

/// Computing time of a whole run without looking at it, as the median of several where it is
/// short [ns per simulated second]. Stops early once the meter says so.
///
/// @param expected  about what one run takes [s], so that short ones are timed many at once
/// @pre as for Run
double nanosecondsPerSimulatedSecond(const std::shared_ptr<const Scene>& scene,
                                     const Solver& solver, double until, double expected,
                                     WorkMeter& meter);

}  // namespace core
