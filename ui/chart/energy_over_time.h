#pragma once

#include "ui/chart/chart_content.h"

namespace ui {

/// Energies over time, one curve for each entry of the ledger: kinetic, potential, lost to air,
/// to impacts, to ropes, to friction (the last two only once they are not zero), and the total.
ChartContent energyOverTime(const ChartSubject& subject, const Theme& theme);

}  // namespace ui
