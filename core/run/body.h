#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/scene/scene.h"

namespace core {

/// What never changes about one weight during a run.
struct Body {
  double mass;            ///< [kg]
  double radius;          ///< [m]
  double drag;            ///< q = ρ c_d A / (2 m) [1/m]
  bool hasRope;           ///< at t = 0
  bool rigid;             ///< a rod, which never goes slack
  double length;          ///< of the rope [m]; 1 without one
  Eigen::Vector2d pivot;  ///< of the rope [m]
};

/// The scene's weights, in its order.
std::vector<Body> bodiesOf(const Scene& scene);

}  // namespace core
