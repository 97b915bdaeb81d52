#pragma once

#include "ui/view/drawing.h"

namespace ui {

class Camera;
class Trails;
struct SceneLook;
struct ShownScene;

/// Smallest radius a weight is drawn with, however small it is [px].
inline constexpr double kLeastRadius = 3;
/// The same for this scene: less with very many weights, or they would cover the room.
double leastRadius(const ShownScene& shown);

/// Whether some weight is so small in this picture that it is drawn larger than it is.
bool enlargesWeights(const ShownScene& shown, const Camera& camera);

/// Adds the ways of all weights of all runs.
void drawTrails(const ShownScene& shown, const Trails& trails, const SceneLook& look,
                Drawing& drawing);

/// Adds pivots, and the ropes of the weights that still hang on one: rods thicker, slack
/// ropes hanging.
void drawRopes(const ShownScene& shown, const SceneLook& look, Drawing& drawing);

/// Adds the weights: those of the first run filled in their own colors, those of the others
/// as outlines in the run's color, joined to the first run's by a line where they differ.
void drawWeights(const ShownScene& shown, const Camera& camera, const SceneLook& look,
                 Drawing& drawing);

}  // namespace ui
