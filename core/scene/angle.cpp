#include "core/scene/angle.h"

#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>

namespace core {

double radians(double inDegrees) {
  return inDegrees / 180 * std::numbers::pi;
}

double degrees(double angle) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double plain = angle / std::numbers::pi * 180;
  // Several neighboring doubles can mean the same angle; a person wrote the short one.
  const double written = std::nearbyint(plain * 1e9) / 1e9;
  for (const double candidate :
       {written, plain, std::nextafter(plain, kInfinity), std::nextafter(plain, -kInfinity)}) {
    if (radians(candidate) == angle) return candidate;
  }
  return plain;
}

}  // namespace core
