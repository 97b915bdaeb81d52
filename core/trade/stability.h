#pragma once

#include <memory>
#include <optional>

#include "core/scene/scene.h"

namespace core {

/// The largest step, to two digits and below the solver's own, with which a run of the scene
/// stays finite up to `until`: what to suggest to whoever saw the numbers explode.
///
/// The step is halved until the run survives, then narrowed down by bisection. A run takes at
/// most so many steps, a few seconds of work altogether, so that a step that small is not
/// found. Runs may survive one step and diverge at a smaller one: the result is a step that
/// was tried, not a bound.
///
/// @param solver  its step is not tried itself: it is known to diverge
/// @param until   [s], > 0
/// @return        [s]; nothing if no step was found
/// @pre as for Run
std::optional<double> largestStableStep(const std::shared_ptr<const Scene>& scene,
                                        const Solver& solver, double until);

}  // namespace core
