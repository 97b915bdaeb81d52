#pragma once

#include <vector>

#include <Eigen/Core>

namespace ui {

/// The curve of a slack rope between two points: a catenary, from `from` to `to` [m].
///
/// Where the rope is no longer than the distance, the straight line.
/// @param length      of the rope [m], > 0
/// @param pointCount  of the curve, ≥ 2, evenly spaced along the rope
std::vector<Eigen::Vector2d> hangingRope(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                         double length, int pointCount = 25);

}  // namespace ui
