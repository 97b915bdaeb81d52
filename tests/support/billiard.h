#pragma once

#include "core/scene/scene.h"

namespace tests {

/// Galperin's billiard: a heavy disc, weight 1, drives a light one, weight 0, against the west
/// wall at 1 m/s. Without friction or loss they meet, and the wall, ⌊π √(mass ratio)⌋ times, all
/// before kBilliardEnd.
core::Scene billiard(double massRatio);

constexpr double kBilliardEnd = 6;  // [s]

/// Exact x of the heavy disc after `time` [m].
double exactBilliardPlace(const core::Scene& scene, double time);

}  // namespace tests
