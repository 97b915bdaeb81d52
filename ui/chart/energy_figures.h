#pragma once

#include <vector>

#include <QString>

#include "ui/chart/chart_content.h"
#include "ui/chart/charted_run.h"

namespace ui {

struct AxisScale;
struct EnergyExtent;

/// A chart of energies over time, without curves yet.
ChartContent emptyEnergyContent();

/// What the method got wrong up to the latest sample, in J and in percent of the start:
/// "drift +0.600 J (+20.0 %)". Empty without samples.
QString driftText(const core::Ledger& ledger);
/// The widest that driftText() commonly is.
QString widestDriftText();

/// That curves leave the scale at the extent's ceiling, and where to; empty without one.
QString ceilingWarning(const std::vector<ChartedRun>& runs, const EnergyExtent& extent,
                       const AxisScale& energy);

/// " − 1,862 J": what was taken off potential and total before they are drawn; empty if nothing.
QString offsetText(const EnergyExtent& extent, const AxisScale& energy);

}  // namespace ui
