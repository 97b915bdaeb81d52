#include "ui/chart/chart_scales.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

namespace ui {

namespace {

// From here on time is in plain seconds.
constexpr double kShortTime = 0.1;  // [s]

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::ChartScales)
};

AxisScale scaleIn(const ScaledUnit& unit, double lowest, double highest, int intervals,
                  AxisEnds ends) {
  AxisScale scale;
  scale.unit = unit;
  scale.ticks = niceScale(lowest / unit.size, highest / unit.size, intervals);
  const bool onTicks = ends == AxisEnds::kOnTicks;
  scale.lowest = onTicks ? scale.ticks.lowest : lowest / unit.size;
  scale.highest = onTicks ? scale.ticks.highest : highest / unit.size;
  return scale;
}

}  // namespace

QString AxisScale::title(const QString& quantity) const {
  return Words::tr("%1 (%2)").arg(quantity, unit.symbol);
}

AxisScale axisScale(const ChartAxis& axis, double lowest, double highest, int intervals,
                    AxisEnds ends) {
  const double largest = std::max(std::abs(lowest), std::abs(highest));
  const ScaledUnit unit = axis.prefixed ? scaledUnit(largest, axis.unit) : ScaledUnit{1, axis.unit};
  return scaleIn(unit, lowest, highest, intervals, ends);
}

AxisScale timeScale(const ChartAxis& axis, double lowest, double highest, int intervals,
                    AxisEnds ends) {
  return scaleIn(scaledUnit(std::min(highest, kShortTime), axis.unit), lowest, highest, intervals,
                 ends);
}

}  // namespace ui
