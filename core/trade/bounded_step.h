#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/methods/method.h"
#include "core/scene/scene.h"
#include "core/trade/work_meter.h"

namespace core {

/// The largest step at which a method stays bounded on a scene.
struct BoundedStep {
  const Method* method = nullptr;
  /// [s], to two digits; nothing if even the smallest step tried ran away.
  std::optional<double> step;
  /// True if no step was too large, up to one step for the whole run or the largest allowed.
  bool isUnlimited = false;
};

/// For each method that takes a step, from the table. Steps are doubled from small ones on until
/// one runs away; where exactly is then narrowed down by bisection. Larger steps may stay bounded
/// by chance and are not looked for.
///
/// @param until     [s], > 0
/// @param progress  may be empty
/// @return          nothing if the progress stopped it
/// @pre problemsIn(*scene) is empty
std::optional<std::vector<BoundedStep>> largestBoundedSteps(
    const std::shared_ptr<const Scene>& scene, double until, const Progress& progress = {});

}  // namespace core
