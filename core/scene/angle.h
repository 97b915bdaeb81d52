#pragma once

namespace core {

/// Degrees, as users read and write them, in radians; a half turn is exactly the double
/// next to π.
double radians(double inDegrees);

/// The inverse of radians(): the shortest number of degrees (up to nine decimals) that
/// means just this angle, so that 70° written by a user is 70° when shown again.
///
/// @param angle  [rad]
/// @return       d with radians(d) == angle where there is such a double, else the nearest
double degrees(double angle);

}  // namespace core
