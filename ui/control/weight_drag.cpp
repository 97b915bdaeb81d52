#include "ui/control/weight_drag.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

#include "core/scene/angle.h"
#include "ui/control/quantity_text.h"

namespace ui {

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::WeightDrag)
};

double powerOfTenBelow(double value) {
  return std::pow(10.0, std::floor(std::log10(value) + 1e-9));
}

/// As the forms write it, but with a true minus sign.
QString written(double value) {
  return quantityText(value).replace('-', QChar(0x2212));
}

/// What a value is rounded to: the largest power of ten up to `fine`, or where the hand snaps,
/// kSnapSteps steps.
double grain(double fine, double step, const HandFineness& fineness) {
  return fineness.snaps ? kSnapSteps * step : powerOfTenBelow(fine);
}

Eigen::Vector2d roundedTo(const Eigen::Vector2d& value, double step) {
  return {ui::roundedTo(value.x(), step), ui::roundedTo(value.y(), step)};
}

/// Unit vector along the circle of the rope, towards larger angles.
Eigen::Vector2d tangent(const core::Rope& rope) {
  return {std::cos(rope.angle), std::sin(rope.angle)};
}

/// An angle [°] from −180 to 180.
double wrapped(double angle) {
  return std::remainder(angle, 360.0);
}

}  // namespace

HandSteps handSteps(const core::Room& room) {
  const double size = std::min(room.width, room.height);
  // What falls that far gets about so fast where nothing is said about gravity.
  return {powerOfTenBelow(size / 200), powerOfTenBelow(std::sqrt(10 * size) / 30)};
}

double roundedTo(double value, double step) {
  // Adding zero turns −0 into 0.
  if (step >= 1) return std::round(value / step) * step + 0.0;
  const double parts = std::round(1 / step);
  return std::round(value * parts) / parts + 0.0;
}

void dragAngle(core::Rope& rope, const Eigen::Vector2d& place, const HandFineness& fineness) {
  const Eigen::Vector2d way = place - rope.pivot;
  const double angle = core::degrees(std::atan2(way.x(), -way.y()));
  const double fine = core::degrees(fineness.length / std::max(way.norm(), fineness.length));
  rope.angle = core::radians(roundedTo(angle, grain(fine, kAngleStep, fineness)));
}

void dragLength(core::Rope& rope, const Eigen::Vector2d& place, const HandFineness& fineness) {
  const double length = (place - rope.pivot).norm();
  rope.length = roundedTo(length, grain(fineness.length, fineness.steps.length, fineness));
}

void dragPosition(core::Weight& weight, const Eigen::Vector2d& place,
                  const HandFineness& fineness) {
  weight.position = roundedTo(place, grain(fineness.length, fineness.steps.length, fineness));
}

void dragVelocity(core::Weight& weight, const Eigen::Vector2d& velocity,
                  const HandFineness& fineness) {
  if (!weight.rope) {
    weight.velocity = roundedTo(velocity, grain(fineness.speed, fineness.steps.speed, fineness));
    return;
  }
  core::Rope& rope = *weight.rope;
  const double turning = core::degrees(velocity.dot(tangent(rope)) / rope.length);
  const double fine = core::degrees(fineness.speed / rope.length);
  rope.angularVelocity = core::radians(roundedTo(turning, grain(fine, kTurnStep, fineness)));
}

void nudge(core::Weight& weight, const Eigen::Vector2d& way, const HandSteps& steps) {
  if (!weight.rope) {
    // Rounded far below a step, so that ten steps of 0.01 m are 0.1 m.
    weight.position = roundedTo(weight.position + steps.length * way, steps.length * 1e-6);
    return;
  }
  core::Rope& rope = *weight.rope;
  if (way.x() != 0)
    rope.angle = core::radians(wrapped(core::degrees(rope.angle) + kAngleStep * way.x()));
  if (way.y() != 0)
    rope.length = roundedTo(rope.length - steps.length * way.y(), steps.length * 1e-6);
}

void nudgeVelocity(core::Weight& weight, const Eigen::Vector2d& way, const HandSteps& steps) {
  if (!weight.rope) {
    weight.velocity = roundedTo(weight.velocity + steps.speed * way, steps.speed * 1e-6);
    return;
  }
  core::Rope& rope = *weight.rope;
  rope.angularVelocity = core::radians(core::degrees(rope.angularVelocity) + kTurnStep * way.x());
}

QString angleWords(const core::Rope& rope) {
  return Words::tr("Angle %1°").arg(written(core::degrees(rope.angle)));
}

QString lengthWords(const core::Rope& rope) {
  return Words::tr("Length %1 m").arg(written(rope.length));
}

QString positionWords(const core::Weight& weight) {
  return Words::tr("x %1 m, y %2 m")
      .arg(written(weight.position.x()), written(weight.position.y()));
}

QString velocityWords(const core::Weight& weight) {
  if (weight.rope)
    return Words::tr("%1 °/s").arg(written(core::degrees(weight.rope->angularVelocity)));
  return Words::tr("vx %1 m/s, vy %2 m/s")
      .arg(written(weight.velocity.x()), written(weight.velocity.y()));
}

}  // namespace ui
