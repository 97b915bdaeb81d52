#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace core {

/// These weights, shifted to where they start inside the room and overlap no weight of the
/// scene: not at all if they do not, else to the side, else up or down, ropes with their
/// pivots. All are shifted together, or if that cannot be, each alone. Those for which no
/// place is found stay as they are; `problemsIn` tells.
///
/// Takes O(M log M) for M weights and a bounded number of tries, fewer for many weights.
std::vector<Weight> placedApart(const Scene& scene, std::vector<Weight> weights);

/// A weight as it is by default, on a rope that is tied to the ceiling and leaves at least half
/// the room below it.
Weight firstWeight(const Room& room);

}  // namespace core
