#pragma once

#include <vector>

#include "ui/view/drawing.h"

class QImage;
class QPainter;

namespace ui {

class Camera;

/// Paints a drawing with QPainter on anything: a vector file, a printer.
///
/// One unit of the painter is a logical pixel of the camera. Nothing is painted outside of the
/// viewport but the outer half of strokes, so no clipping is needed.
void paintDrawing(const Drawing& drawing, const Camera& camera, QPainter& painter);

/// Paints a drawing into an image; many discs many times faster than with a QPainter.
/// @pre the image has the camera's viewport × devicePixelRatio pixels, and the format RGB32
void paintDrawing(const Drawing& drawing, const Camera& camera, QImage& image);

/// Paints only the words, over what another painter drew.
void paintTexts(const std::vector<Text>& texts, const Camera& camera, QPainter& painter);

}  // namespace ui
