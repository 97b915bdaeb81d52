#pragma once

#include <optional>
#include <vector>

#include <QColor>
#include <QPointF>
#include <QSizeF>
#include <QString>

namespace ui {

class ChartPlot;

/// Where one curve is at some moment.
struct ChartReading {
  QString name;
  std::size_t run = 0;
  QColor color;
  QPointF place;  ///< in the units of the axes, as drawn
  QString text;   ///< with its unit: "1.23 J"; of curves not over time both: "12.0°, 3.10 °/s"
};

/// One for each curve that is shown and has a value then.
/// @param time  [s]
std::vector<ChartReading> readingsAt(const ChartPlot& plot, double time);

/// The moment whose place on any of the curves is nearest to `place`, measured in units of
/// this size; nothing if none is within `most` [px].
/// @param place     in the units of the axes
/// @param unitSize  of one unit along both axes [px]
std::optional<double> nearestTime(const ChartPlot& plot, QPointF place, QSizeF unitSize,
                                  double most);

/// A moment in words: "1.234 s".
QString momentText(double time);

}  // namespace ui
