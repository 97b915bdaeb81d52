#pragma once

#include <cstddef>

#include <QList>
#include <QPen>
#include <QPointF>
#include <QSizeF>

namespace ui {

/// The line of a run: solid for the first, dashed, dotted, dash-dotted for the others.
QPen runPen(const QColor& color, double width, std::size_t run);

/// Whether a curve swings up and down so often that dashes along it could neither be told
/// apart nor painted in time (a dashed stroke takes ten times as long as a solid one).
///
/// @param unit  size of one unit along both axes [px]
bool isTooDenseForDashes(const QList<QPointF>& curve, QSizeF unit);

/// Whether it does so often that even a smooth solid line along it takes too long.
bool isTooDenseForSmoothLines(const QList<QPointF>& curve, QSizeF unit);

/// What to draw such a curve with instead: a thin solid line.
QPen densePen(const QColor& color);

}  // namespace ui
