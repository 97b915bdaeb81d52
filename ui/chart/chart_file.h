#pragma once

#include <QImage>
#include <QSizeF>
#include <QString>

class QChart;

namespace ui {

/// Writes a chart as PNG, SVG or PDF by the file's ending; needs no display. PNG: 300 dpi,
/// twice the pixels the chart was laid out with. Never leaves a half-written file.
///
/// @param chart  in a scene of its own, with ChartLook::forPaper(); is given that size
///               and pens to match
/// @param title  for the file's properties
/// @param size   in mm on paper
/// @return       empty, or what went wrong in words, without the file's name
QString writeChart(QChart& chart, const QString& file, const QString& title, QSizeF size);

/// The same as pixels, at 300 dpi.
QImage chartImage(QChart& chart, QSizeF size);

}  // namespace ui
