#include "ui/view/picking.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/view/arrow_scale.h"
#include "ui/view/camera.h"
#include "ui/view/shown_scene.h"
#include "ui/view/weight_drawing.h"

namespace ui {

namespace {

constexpr double kLeastGripDistance = 26;  // from the weight's edge [px]

double distance(QPointF a, QPointF b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

/// From the pixel to the edge of the disc as it is drawn; 0 inside [px].
double distanceToEdge(QPointF center, double radius, QPointF pixel) {
  return std::max(distance(center, pixel) - radius, 0.0);
}

/// Unit vector the weight sets out along, or could.
Eigen::Vector2d wayOf(const core::Weight& weight) {
  const Eigen::Vector2d velocity = core::startVelocity(weight);
  if (velocity.norm() > 0) return velocity.normalized();
  if (!weight.rope) return {1, 0};
  return {std::cos(weight.rope->angle), std::sin(weight.rope->angle)};
}

}  // namespace

std::optional<int> weightNear(const ShownScene& shown, const Camera& camera, QPointF pixel) {
  std::optional<int> nearest;
  // Of weights under the pointer the smallest counts, for it can be hidden by the others.
  std::array<double, 3> least{kPickReach, 0, 0};
  const double leastDrawn = leastRadius(shown);
  for (const ShownRun& run : shown.runs) {
    for (std::size_t i = 0; i < run.weights.size(); ++i) {
      const double radius = std::max(shown.scene.weights[i].radius * camera.scale(), leastDrawn);
      const QPointF center = camera.toPixels(run.weights[i].position);
      const std::array<double, 3> rank{distanceToEdge(center, radius, pixel), radius,
                                       distance(center, pixel)};
      if (rank[0] > kPickReach || (nearest && rank >= least)) continue;
      least = rank;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

bool isNear(const Eigen::Vector2d& place, double radius, const Camera& camera, QPointF pixel) {
  const double drawn = std::max(radius * camera.scale(), kLeastRadius);
  return distanceToEdge(camera.toPixels(place), drawn, pixel) <= kPickReach;
}

QPointF velocityGrip(const core::Weight& weight, const ArrowScales& scales, const Camera& camera) {
  const double arrow = core::startVelocity(weight).norm() * scales.pixelsPerSpeed();
  const double radius = std::max(weight.radius * camera.scale(), kLeastRadius);
  const Eigen::Vector2d way = std::max(arrow, radius + kLeastGripDistance) * wayOf(weight);
  return camera.toPixels(core::startPosition(weight)) + QPointF(way.x(), -way.y());
}

}  // namespace ui
