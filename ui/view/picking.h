#pragma once

#include <optional>

#include <Eigen/Core>

#include <QPointF>

#include "core/scene/scene.h"

namespace ui {

class Camera;
struct ArrowScales;
struct ShownScene;

/// How far beside a weight it is still meant [px]: small ones are easy to hit, too.
inline constexpr double kPickReach = 12;

/// The weight that lies nearest to this pixel in any of the runs; nothing within kPickReach of
/// a weight's edge: none.
/// @return  index
std::optional<int> weightNear(const ShownScene& shown, const Camera& camera, QPointF pixel);

/// Whether a weight at this place is within reach of the pixel.
bool isNear(const Eigen::Vector2d& place, double radius, const Camera& camera, QPointF pixel);

/// Where to take hold of a weight's start velocity [px]: at the tip of its arrow; where the arrow
/// is hardly longer than the weight, beside the weight, along its rope's circle or to the right.
QPointF velocityGrip(const core::Weight& weight, const ArrowScales& scales, const Camera& camera);

}  // namespace ui
