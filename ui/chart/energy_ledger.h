#pragma once

#include "ui/chart/chart_content.h"

namespace ui {

/// The ledger as a stack: where the energy is and where it went. What the method got wrong is
/// hatched between the energy at the start and the top of the stack, above it or below.
/// The first run's entries are bands; of further runs the upper edges are lines.
ChartContent energyLedger(const ChartSubject& subject, const Theme& theme);

}  // namespace ui
