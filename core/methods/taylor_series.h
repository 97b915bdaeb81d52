#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

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

  /// The longest time over which neither of the last two terms of any quantity exceeds its error.
  ///
  /// @param series  of the quantities, as many as there are errors or more
  /// @param errors  in the quantities' units, > 0
  /// @return        [s]; infinite where all those terms are zero, not a number where one is none
  static double reach(std::span<const Series> series, std::span<const double> errors) {
    // The root is taken once, of the term that matters: roots cost as much as the series.
    const auto within = [&](int k) {
      double largest = 0;
      for (std::size_t i = 0; i < errors.size(); ++i) {
        const double share = std::abs(series[i][k]) / errors[i];
        if (share > largest || std::isnan(share)) largest = share;
      }
      return std::pow(largest, -1.0 / k);
    };
    return std::min(within(kSeriesDegree), within(kSeriesDegree - 1));
  }
};

}  // namespace core
