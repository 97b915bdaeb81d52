#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/scene/scene.h"

namespace core {

/// A disc in the plane.
struct Disc {
  Eigen::Vector2d center{0, 0};  ///< [m]
  double radius = 0;             ///< [m]
};

/// Two discs, by index, that share more than a touch.
struct Overlap {
  int disc;   ///< the smaller one; of two about as large (within a factor of two) the later one
  int other;  ///< the one it overlaps
};

/// Share of the radii's sum that may be lost to rounding where discs merely touch.
inline constexpr double kTouchTolerance = 1e-9;

/// Overlaps among discs of any mixture of sizes: at most one per `disc`, in its order.
///
/// In a heap of dozens at one place some may be left out until others have moved; that
/// bounds the time to O(N log N) whatever the discs. Discs whose radius is not in
/// kRadiusRange, or whose center lies farther from the origin than any room reaches, are
/// left out.
std::vector<Overlap> overlapsAmong(std::span<const Disc> discs);

/// Where the weights of the scene are at t = 0, one disc each.
std::vector<Disc> startDiscs(const Scene& scene);

}  // namespace core
