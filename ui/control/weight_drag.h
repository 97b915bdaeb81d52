#pragma once

#include <Eigen/Core>

#include <QString>

#include "core/scene/scene.h"

namespace ui {

/// The steps by which keys move things in a scene, and 5 times which the hand snaps to: powers of
/// ten that suit the size of its room.
struct HandSteps {
  double length;  ///< [m]
  double speed;   ///< [m/s]
};
HandSteps handSteps(const core::Room& room);

inline constexpr double kAngleStep = 1;  ///< [°]
inline constexpr double kTurnStep = 5;   ///< of angular velocities [°/s]
inline constexpr double kSnapSteps = 5;

/// The nearest multiple of `step`, and of all doubles the one that is written with the fewest
/// digits.
/// @param step  > 0, a power of ten or 5 or 2 times one
double roundedTo(double value, double step);

/// How exactly a hand leads what it holds.
struct HandFineness {
  double length = 1e-3;  ///< how wide a pixel is [m]
  double speed = 1e-2;   ///< what a pixel of a velocity's arrow means [m/s]
  bool snaps = false;    ///< to kSnapSteps steps
  HandSteps steps{0.01, 0.1};
};

/// Turns the rope so that it points at `place` [m], seen from its pivot.
void dragAngle(core::Rope& rope, const Eigen::Vector2d& place, const HandFineness& fineness);

/// Makes the rope as long as `place` [m] is away from its pivot.
void dragLength(core::Rope& rope, const Eigen::Vector2d& place, const HandFineness& fineness);

/// Puts a free weight's center at `place` [m].
void dragPosition(core::Weight& weight, const Eigen::Vector2d& place, const HandFineness& fineness);

/// Sets a weight out with this velocity [m/s]; one on a rope with what of it is along its circle.
void dragVelocity(core::Weight& weight, const Eigen::Vector2d& velocity,
                  const HandFineness& fineness);

/// Moves a weight by one step: to the side by kAngleStep or a length, upwards by a length, which a
/// rope gets shorter by.
/// @param way  x and y of −1, 0 or 1
void nudge(core::Weight& weight, const Eigen::Vector2d& way, const HandSteps& steps);

/// The same for its velocity; one on a rope has only one to the side.
void nudgeVelocity(core::Weight& weight, const Eigen::Vector2d& way, const HandSteps& steps);

// What a weight is set to, for a class to read: "Angle 35.5°".
QString angleWords(const core::Rope& rope);
QString lengthWords(const core::Rope& rope);
QString positionWords(const core::Weight& weight);
QString velocityWords(const core::Weight& weight);

}  // namespace ui
