#pragma once

#include <span>

#include <QString>

#include "ui/chart/chart_content.h"

namespace ui {

/// A kind of chart the window offers.
struct ChartKind {
  const char* id;          ///< in settings and names of files
  const char* sourceName;  ///< English, for translation
  const char* sourceTip;
  bool ofWeights;  ///< shows chosen weights, not whole runs
  ChartContent (*content)(const ChartSubject&, const Theme&);

  QString name() const;
  QString tip() const;
};

/// In the order of their tabs. To add a kind, write its unit and put its row here.
std::span<const ChartKind> chartKinds();

/// Energies over time: the kind that is shown first, and that needs a ledger alone.
const ChartKind& energyChartKind();

}  // namespace ui
