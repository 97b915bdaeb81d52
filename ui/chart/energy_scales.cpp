#include "ui/chart/energy_scales.h"

#include <algorithm>

#include <QCoreApplication>

#include "ui/chart/energy_extent.h"

namespace ui {

namespace {

// Between the highest curve and the top of the plot.
constexpr double kHeadroom = 1.04;
// From here on time is in plain seconds: nobody reads kiloseconds.
constexpr double kShortTime = 0.1;  // [s]

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::EnergyChart)
};

NiceScale inUnit(const ScaledUnit& unit, double lowest, double highest, int intervals) {
  return niceScale(lowest / unit.size, highest / unit.size, intervals);
}

}  // namespace

EnergyScales energyScales(const EnergyExtent& extent, double leastTime, int timeIntervals,
                          int energyIntervals) {
  const double end = std::max(extent.lastTime, leastTime);
  const double top = extent.ceiling.value_or(extent.highest * kHeadroom);
  EnergyScales scales;
  scales.timeUnit = scaledUnit(std::min(end, kShortTime), Words::tr("s"));
  scales.time = inUnit(scales.timeUnit, 0, end, timeIntervals);
  scales.energyUnit = scaledUnit(top, Words::tr("J"));
  scales.energy = inUnit(scales.energyUnit, extent.lowest, top, energyIntervals);
  return scales;
}

}  // namespace ui
