#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace core {

/// One point of a curve, and when it was passed.
struct TimedPoint {
  double time;  ///< [s]
  double x;     ///< the time itself, or anything that changes with it
  double y;

  bool operator==(const TimedPoint&) const = default;
};

/// Fewer points for a curve, every peak kept: the stretch of time is divided evenly and of
/// each part the first and last point and those with the lowest and highest x and y stay, in
/// order. (Of a curve over time the first and last are those with the lowest and highest x.)
///
/// @param curve  in order of time
/// @param most   points wanted at most, ≥ 12
/// @return       the curve itself when it is short enough; first and last point always stay
std::vector<TimedPoint> thinned(std::span<const TimedPoint> curve, std::size_t most);

}  // namespace core
