#pragma once

#include <QIcon>
#include <QString>

class QColor;
class QPainter;
class QRectF;

namespace ui {

/// One of our own icons, drawn sharp at any size in the text color of the palette in force,
/// so that it suits light and dark windows and follows a change at once.
///
/// @param name  of a file in resources/icons, without its ending
/// @pre there is such a file
QIcon icon(const QString& name);

/// The same on a drawing, in a color of its own.
/// @pre as for icon()
void drawIcon(QPainter& painter, const QString& name, const QRectF& place, const QColor& color);

}  // namespace ui
