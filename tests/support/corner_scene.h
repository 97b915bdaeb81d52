#pragma once

#include <string>

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

/// Takes up to `steps` steps of the scene at that corner and looks whether every number stays
/// finite, every weight in the room (to 10⁻⁶ m, or what rounding leaves of a place in the
/// largest rooms) and apart from the others (to a hundredth of the radii: one of 10⁹ kg lies on
/// one of 10⁻⁶ kg), and whether it takes less than a minute of processor time. A run that
/// ends with a status that says why counts as sound.
///
/// @return  what is wrong, in words; empty if nothing is
std::string faultAtCorner(int corner, const core::Solver& solver, int steps);

}  // namespace tests
