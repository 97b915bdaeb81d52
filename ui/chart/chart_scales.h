#pragma once

#include <QRectF>

#include "ui/chart/chart_content.h"
#include "ui/chart/figure_text.h"
#include "ui/chart/nice_scale.h"

namespace ui {

/// One axis: what it spans, in a unit that keeps its labels short.
struct AxisScale {
  ScaledUnit unit;
  double lowest = 0;   ///< in that unit
  double highest = 1;  ///< in that unit
  NiceScale ticks;     ///< in that unit, at least from lowest to highest

  /// "Energy (kJ)"
  QString title(const QString& quantity) const;
};

/// Whether an axis may end a little further out, on a tick.
enum class AxisEnds { kOnTicks, kExact };

/// @param lowest, highest  in the axis' unit without prefix
/// @param intervals        most intervals between labels, ≥ 1
AxisScale axisScale(const ChartAxis& axis, double lowest, double highest, int intervals,
                    AxisEnds ends);

/// The same for time: in plain seconds from 0.1 s on, for nobody reads kiloseconds.
AxisScale timeScale(const ChartAxis& axis, double lowest, double highest, int intervals,
                    AxisEnds ends);

}  // namespace ui
