#pragma once

class QImage;

namespace ui {

struct Shape;

/// Paints a shape into an image, antialiased, at its exact place between pixels.
///
/// A small disc or a piece of a trail costs well under a microsecond: QPainter's own
/// antialiased paths take ten times as long, too long for the trails of a class of weights.
/// @pre the image's format is RGB32
void paintShape(const Shape& shape, QImage& image);

}  // namespace ui
