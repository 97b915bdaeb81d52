#pragma once

#include <optional>
#include <vector>

#include "core/aim/target.h"

namespace ui {

/// Where a weight came to the floor for the first time after the cut.
struct ShownLanding {
  double place = 0;  ///< x of the center [m]
  double time = 0;   ///< [s]
};

/// A target on the floor, and what has become of the weight that is to hit it.
struct ShownTarget {
  core::Target place;
  /// One for each run; nothing while it has not landed.
  std::vector<std::optional<ShownLanding>> landings;
};

}  // namespace ui
