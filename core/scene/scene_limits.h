#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace core {

/// Closed interval a quantity may lie in.
struct Range {
  double lowest;
  double highest;
  std::string_view unit;  ///< of both ends, as it is written behind a number; may be empty

  /// False for NaN.
  bool contains(double value) const { return lowest <= value && value <= highest; }
};

// Ranges as users read and write them: SI units, but degrees for angles.
inline constexpr Range kGravityRange{0, 1000, "m/s²"};
inline constexpr Range kAirDensityRange{0, 2000, "kg/m³"};
inline constexpr Range kRoomSizeRange{0.01, 1e5, "m"};
inline constexpr Range kRestitutionRange{0, 1, ""};
inline constexpr Range kFrictionRange{0, 10, ""};
inline constexpr Range kCutTimeRange{0, std::numeric_limits<double>::max(), "s"};
inline constexpr Range kMassRange{1e-6, 1e9, "kg"};
inline constexpr Range kRadiusRange{1e-4, 100, "m"};
inline constexpr Range kDragCoefficientRange{0, 10, ""};
inline constexpr Range kRopeLengthRange{1e-3, 1e4, "m"};
inline constexpr Range kRopeAngleRange{-180, 180, "°"};
inline constexpr Range kAngularVelocityRange{-1e5, 1e5, "°/s"};
inline constexpr Range kVelocityRange{-1e5, 1e5, "m/s"};
inline constexpr Range kStepRange{1e-7, 10, "s"};
inline constexpr Range kToleranceRange{1e-14, 1, ""};
inline constexpr int kMostWeights = 100000;
inline constexpr int kMostSolvers = 4;

/// One thing the user must correct. ui/ says it in words.
struct Problem {
  enum class Kind {
    kOutOfRange,   ///< `value` is not in `allowed`
    kOutsideRoom,  ///< a pivot (`value` 0) or a disc of radius `value` [m] reaches out, at `at`
    kOverlap,      ///< the weight overlaps the one with index `other`
    kTooMany       ///< `value` entries where at most `allowed.highest` may stand
  };

  std::string place;  ///< key as in scene files: "weights[3].rope.length"; of two numbers in
                      ///< brackets the one: "weights[3].velocity[0]"; of a hanging weight
                      ///< that starts outside the room: "weights[3].rope"
  Kind kind;
  double value = 0;  ///< as the user wrote it: degrees for angles
  Range allowed{0, 0, ""};
  int other = -1;               ///< index of the other weight, or -1
  Eigen::Vector2d at = {0, 0};  ///< where the point or the disc's center is [m]
};

/// Every problem in `scene`, in the order of the keys in a scene file; empty if it can run.
///
/// Changes nothing and never throws: correcting a value is the user's decision. Method
/// names are not looked at: `methods/method.h` knows them. What merely touches (a gap down
/// to −kTouchTolerance of the radii's sum, or to a wall of the radius) neither overlaps nor
/// is outside. Where a weight starts is looked at when all that decides it is in range.
/// Takes O(N log N) for N weights, and lists at most one overlap per weight.
std::vector<Problem> problemsIn(const Scene& scene);

/// A number as a person would write it: shortest digits that read back, without exponent
/// between 10⁻⁴ and 10⁷, '.' as decimal point.
std::string numberText(double value);

}  // namespace core
