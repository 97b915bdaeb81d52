#include "ui/view/hanging_rope.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ui {

namespace {

/// b > 0 with sinh(b) / b = ratio.
/// @pre ratio > 1
double catenaryShape(double ratio) {
  double low = 0;
  double high = std::sqrt(6 * (ratio - 1));  // because sinh(b) / b ≥ 1 + b² / 6
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (std::sinh(middle) < ratio * middle ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

std::vector<Eigen::Vector2d> hangingRope(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                         double length, int pointCount) {
  assert(length > 0 && pointCount >= 2);
  const Eigen::Vector2d chord = to - from;
  // Both would make the catenary's formulas degenerate, and look like a straight line.
  if (chord.norm() > length * (1 - 1e-9)) return {from, to};
  // A rope between two points above each other is drawn as if they were a little apart.
  const double width = std::max(std::abs(chord.x()), length * 1e-3);
  const double rise = chord.y();

  // y = a cosh((x − lowest) / a), x from 0 to width; s is the length along the rope.
  const double a = width / 2 / catenaryShape(std::sqrt(length * length - rise * rise) / width);
  const double lowest = width / 2 - a * std::atanh(rise / length);
  const double lengthToLowest = a * std::sinh(lowest / a);
  std::vector<Eigen::Vector2d> points(pointCount);
  for (int i = 0; i < pointCount; ++i) {
    const double s = length * i / (pointCount - 1) - lengthToLowest;
    const double x = lowest + a * std::asinh(s / a);
    const double y = std::hypot(s, a) - std::hypot(lengthToLowest, a);
    points[i] = from + Eigen::Vector2d(x / width * chord.x(), y);
  }
  return points;
}

}  // namespace ui
