#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/methods/method.h"
#include "core/motion/series.h"

namespace core {

/// The reference solution's method: in every step the solution's own Taylor polynomial, as long
/// as its last terms do not matter. Not offered to users: it asks the motion for more than its
/// slope.
/// Source: Jorba & Zou, A software package for the numerical integration of ODEs by means of
/// high-order Taylor methods, Experimental Mathematics 14 (2005), §3.
struct TaylorSeries {
  static constexpr Method kRow{.id = "reference",
                               .name = "Reference",
                               .order = kSeriesDegree,
                               .slopesPerStep = 1,
                               .path = PathShape::kPolynomial,
                               .isAdaptive = true,
                               .isOffered = false};

  /// The longest time over which neither of the last two terms of one quantity exceeds `error`.
  ///
  /// @param error  in the quantity's unit, > 0
  /// @return       [s]; infinite where both terms are zero, not a number where one is none
  static double reach(const Series& series, double error) {
    const auto within = [&](int k) { return std::pow(error / std::abs(series[k]), 1.0 / k); };
    return std::min(within(kSeriesDegree), within(kSeriesDegree - 1));
  }
};

}  // namespace core
