#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace core {

/// One point of a curve.
struct CurvePoint {
  double x;
  double y;

  bool operator==(const CurvePoint&) const = default;
};

/// Fewer points for a curve, every peak kept: the stretch of x is divided evenly and of
/// each part the first, lowest, highest and last point stay, in order.
///
/// @param curve  in order of x
/// @param most   points wanted at most, ≥ 8
/// @return       the curve itself when it is short enough; first and last point always stay
std::vector<CurvePoint> thinned(std::span<const CurvePoint> curve, std::size_t most);

}  // namespace core
