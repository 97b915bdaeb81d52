#pragma once

#include <QSizeF>
#include <QString>

class QChart;

namespace ui {

/// Writes a chart as PNG, SVG or PDF by the file's ending; needs no display. PNG: twice the
/// pixels, 300 dpi. Never leaves a half-written file.
///
/// @param chart  in a scene of its own and with a look for paper, see paperSize(); is given
///               that size
/// @param size   in mm on paper
/// @return       empty, or what went wrong in words
QString writeChart(QChart& chart, const QString& file, QSizeF size);

/// Size that a chart has in its scene for a size on paper [mm]: px at 96 dpi.
QSizeF paperSize(QSizeF millimeters);

}  // namespace ui
