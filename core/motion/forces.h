#pragma once

#include <Eigen/Core>

#include "core/motion/drag.h"
#include "core/scene/scene.h"

namespace core {

// The forces on one weight, as vectors in the plane [N], for showing them: the slopes in
// swing.h and flight.h hold the same terms per mass. Derivation: core/model.md, "Forces".

/// (0, −m g).
/// @param gravity  g [m/s²]
inline Eigen::Vector2d gravityOn(const Weight& weight, double gravity) {
  return {0, -weight.mass * gravity};
}

/// −½ ρ c_d A |v| v: against the whole velocity.
/// @param airDensity  ρ [kg/m³]
/// @param velocity    v [m/s]
inline Eigen::Vector2d dragOn(const Weight& weight, double airDensity,
                              const Eigen::Vector2d& velocity) {
  return -weight.mass * dragFactor(weight, airDensity) * velocity.norm() * velocity;
}

/// T towards the pivot; a rod that pushes has T < 0.
/// @param pivot     where the rope is tied [m]
/// @param position  of the weight's center [m], not the pivot itself
/// @param tension   T [N]
inline Eigen::Vector2d tensionOn(const Eigen::Vector2d& pivot, const Eigen::Vector2d& position,
                                 double tension) {
  return tension * (pivot - position).normalized();
}

}  // namespace core
