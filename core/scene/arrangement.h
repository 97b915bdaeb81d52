#pragma once

#include "core/scene/scene.h"

namespace core {

/// Color of the weight with this index where the scene names none: eight colors that stay
/// apart for color-blind eyes (Okabe and Ito's set, grey for black) for the first eight
/// weights, then colors that look random but are the same every time.
Color defaultColor(int index);

/// The weight's own color, or its default.
Color colorOf(const Scene& scene, int index);

/// Makes `count` weights of the scene: keeps those there are, drops the last ones or adds
/// copies of the last one (a default weight on a rope if there is none), then hangs all
/// that have a rope at even intervals across the room, in the order of the list. Copies
/// take the default color of their place in the list.
///
/// The pivots stay at the height of the first rope's pivot, and so far from the walls that
/// the weights swing between them; where the room is too narrow for that, that they start
/// between them. Copies of a weight without a rope stand beside it. Whether the result can
/// run (the room may be too small for so many) is for `problemsIn` to say.
///
/// @param count  0 to kMostWeights
Scene withWeightCount(const Scene& scene, int count);

}  // namespace core
