#pragma once

#include "core/scene/scene.h"

namespace tests {

/// How many two-valued choices make up a corner of the allowed ranges.
constexpr int kCornerChoices = 12;

/// A scene at a corner of what scene files allow: one bit for each choice between the lowest
/// and the highest gravity, air density, room size, restitution of walls and of weights,
/// friction, mass, radius, drag coefficient, rope length, speed, and whether all ropes are cut
/// within the first step. It holds a weight on a rope, one on a rod, two that fly at each
/// other, one that lies on the floor and one that falls onto it. What would not fit into the room
/// is made as large as it can be there.
///
/// @param corner  0 to 2^kCornerChoices − 1
/// @post problemsIn() finds nothing wrong with it
core::Scene cornerScene(int corner);

}  // namespace tests
