#pragma once

#include <cstdint>

#include "core/scene/scene.h"

namespace tests {

/// A scene made up by a seed, the same every time: a room about as large as a cupboard, with
/// or without air, gravity and friction, and in it weights of mixed sizes on ropes and rods
/// and in flight.
///
/// @param weights  as many as are wanted; fewer where no more fit in
core::Scene randomScene(std::uint32_t seed, int weights);

}  // namespace tests
