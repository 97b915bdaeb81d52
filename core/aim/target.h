#pragma once

#include <cmath>

namespace core {

/// A stretch of the floor to land on.
struct Target {
  double center = 0;  ///< x [m]
  double width = 0;   ///< [m], > 0

  double west() const { return center - width / 2; }
  double east() const { return center + width / 2; }
  /// Both edges belong to it.
  bool holds(double place) const { return west() <= place && place <= east(); }
  /// How far a place is from the nearer edge [m]; 0 on the target.
  double missedBy(double place) const { return std::fmax(0, std::abs(place - center) - width / 2); }

  bool operator==(const Target&) const = default;
};

}  // namespace core
