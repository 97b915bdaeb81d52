#pragma once

#include <vector>

class QImage;

namespace ui {

struct Shape;

/// Paints shapes into an image one over the other, antialiased, at their exact places between
/// pixels.
///
/// A small disc or a piece of a trail costs well under a microsecond: QPainter's own
/// antialiased paths take ten times as long, too long for the trails of a class of weights. Very
/// many shapes are painted by several processors, to the same pixels.
/// @pre the image's format is RGB32
void paintShapes(const std::vector<Shape>& shapes, QImage& image);

}  // namespace ui
