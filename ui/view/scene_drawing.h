#pragma once

#include <QMarginsF>

#include "ui/view/drawing.h"

namespace ui {

class Camera;
class Trails;
struct SceneLook;
struct ShownScene;

/// Everything there is to see of runs at one moment, as the camera sees it.
Drawing sceneDrawing(const ShownScene& shown, const Trails& trails, const Camera& camera,
                     const SceneLook& look);

/// Where the words above the room end [px].
double wordsTop(const ShownScene& shown, const Camera& camera, const SceneLook& look);

/// Room around the fitted room for numbers and legend [px].
/// @param width  of the picture [px]
QMarginsF sceneMargins(const ShownScene& shown, const SceneLook& look, double width);

}  // namespace ui
