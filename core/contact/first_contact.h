#pragma once

#include <optional>

#include "core/contact/path.h"

namespace core {

/// How close counts as touching, and how slow as still. Both grow with the numbers they are
/// made from, because those are rounded.
struct ContactTolerance {
  double gap = 1e-12;    ///< [m]
  double speed = 1e-12;  ///< [m/s]
};

/// Where on a common stretch of time something begins to touch.
struct Contact {
  double u;               ///< 0 to 1 on the stretch
  bool pressing = false;  ///< they touch at rest at u = 0 and are pushed together, not hit
};

/// First moment at which two weights touch while both follow their paths over the same
/// stretch of time.
///
/// The squared gap is a polynomial of degree 6, written in Bernstein form: if all its
/// coefficients are positive the weights cannot meet, which settles almost every pair;
/// otherwise the first root is isolated by subdivision. A gap that closes and opens again
/// inside one step is therefore never missed. Weights that touch at the start and move
/// apart meet again only where the rest of the polynomial says so.
///
/// @param touching  sum of the radii [m], > 0
/// @param duration  of the stretch [s], ≥ 0
/// @return          approaching contact; nothing if they do not meet
std::optional<Contact> firstContact(const Path& a, const Path& b, double touching, double duration,
                                    const ContactTolerance& tolerance);

/// The same for a disc and a wall: first moment at which `distance` falls to zero.
///
/// @param distance  from the disc's edge to the wall, positive inside the room [m]
/// @param speed     its rate of change at the start [m/s]
std::optional<Contact> firstWallContact(const Bernstein<3>& distance, double speed, double duration,
                                        const ContactTolerance& tolerance);

/// First moment at which the center's distance from a fixed point rises to `length`: a
/// slack rope goes taut.
///
/// @param length               [m], > 0
/// @param outwardAcceleration  second derivative of the distance at the start [m/s²]. It
///                             decides where the weight starts on the circle and along it:
///                             the path's own second derivative is only good to h². Exactly
///                             0 where it vanishes to within rounding.
std::optional<double> firstTaut(const Path& path, const Eigen::Vector2d& pivot, double length,
                                double duration, double outwardAcceleration,
                                const ContactTolerance& tolerance);

}  // namespace core
