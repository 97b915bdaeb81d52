#pragma once

#include <numbers>

#include "core/scene/scene.h"

namespace core {

/// q = ρ c_d A / (2 m), A = π r²: drag slows a speed v by q v² [1/m].
inline double dragFactor(const Weight& weight, double airDensity) {
  const double area = std::numbers::pi * weight.radius * weight.radius;
  return airDensity * weight.dragCoefficient * area / (2 * weight.mass);
}

}  // namespace core
