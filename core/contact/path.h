#pragma once

#include <array>

#include <Eigen/Core>

#include "core/contact/bernstein.h"

namespace core {

/// A weight's center over a stretch of time, as a cubic: four Bézier control points [m],
/// for u from 0 to 1.
struct Path {
  std::array<Eigen::Vector2d, 4> points;
  /// At the start [m/s]. The points tell it too, but over a short stretch not to the digits
  /// that decide whether two weights in touch part or press.
  Eigen::Vector2d velocity;

  /// The cubic through both ends with both velocities (Hermite).
  /// @param duration  of the stretch [s], ≥ 0
  static Path through(const Eigen::Vector2d& begin, const Eigen::Vector2d& beginVelocity,
                      const Eigen::Vector2d& end, const Eigen::Vector2d& endVelocity,
                      double duration) {
    return {
        {begin, begin + beginVelocity * (duration / 3), end - endVelocity * (duration / 3), end},
        beginVelocity};
  }

  /// One coordinate as a polynomial [m]; 0 for x, 1 for y.
  Bernstein<3> coordinate(int axis) const {
    return {points[0][axis], points[1][axis], points[2][axis], points[3][axis]};
  }
};

/// Axis-parallel box [m].
struct Box {
  Eigen::Vector2d low;
  Eigen::Vector2d high;

  bool meets(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

/// A box that holds a disc of that radius all along the path.
inline Box boxAround(const Path& path, double radius) {
  const auto& p = path.points;
  const Eigen::Vector2d margin(radius, radius);
  return {p[0].cwiseMin(p[1]).cwiseMin(p[2]).cwiseMin(p[3]) - margin,
          p[0].cwiseMax(p[1]).cwiseMax(p[2]).cwiseMax(p[3]) + margin};
}

}  // namespace core
