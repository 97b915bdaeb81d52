#pragma once

#include <cmath>

namespace core {

/// Down to two digits: 0.0123 becomes 0.012.
/// @pre step > 0
inline double roundedDown(double step) {
  const double digit = std::pow(10, std::floor(std::log10(step)) - 1);
  // A step that has two digits already may be a last digit below them.
  return std::floor(step / digit * (1 + 1e-12)) * digit;
}

}  // namespace core
