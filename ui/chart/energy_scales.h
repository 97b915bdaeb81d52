#pragma once

#include "ui/chart/figure_text.h"
#include "ui/chart/nice_scale.h"

namespace ui {

struct EnergyExtent;

/// Axes of an energy chart, in units that keep their labels short.
struct EnergyScales {
  ScaledUnit timeUnit;
  NiceScale time;
  ScaledUnit energyUnit;
  NiceScale energy;
};

/// @param leastTime        the time axis reaches at least to there [s]
/// @param timeIntervals    most intervals between labels, ≥ 1
EnergyScales energyScales(const EnergyExtent& extent, double leastTime, int timeIntervals,
                          int energyIntervals);

}  // namespace ui
