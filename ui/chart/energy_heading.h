#pragma once

#include <vector>

#include "ui/chart/chart_heading.h"
#include "ui/chart/charted_run.h"

namespace ui {

struct EnergyExtent;
struct EnergyScales;

/// Legend, runs and their drift in figures, and a warning where curves leave the scale.
HeadingContent energyHeading(const std::vector<ChartedRun>& runs, const EnergyExtent& extent,
                             const EnergyScales& scales, const Theme& theme);

}  // namespace ui
