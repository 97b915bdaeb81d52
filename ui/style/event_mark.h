#pragma once

#include <QPointF>

#include "core/run/event.h"

class QPainter;

namespace ui {

struct Theme;

/// Draws the sign that stands for a kind of event wherever one is shown. Kinds differ in
/// shape as well as in color:
/// × cut · ○ turning point · □ rope slack · ■ rope taut · triangles that point to the wall
/// that is hit · ◆ impact of weights · ▬ comes to rest.
///
/// @param size  width and height [px]
void drawEventMark(QPainter& painter, core::EventKind kind, QPointF centre, double size,
                   const Theme& theme);

}  // namespace ui
