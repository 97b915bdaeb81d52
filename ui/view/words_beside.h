#pragma once

#include <QPointF>
#include <QSizeF>

namespace ui {

/// Upper left corner of a box of words beside the middle of a stroke, clear of it whichever way
/// it leads: above a level one, at the right of an upright one. All in pixels.
/// @param gap  between stroke and box
QPointF cornerBeside(QPointF from, QPointF to, QSizeF box, double gap);

}  // namespace ui
