#pragma once

#include <cstddef>
#include <vector>

#include <QString>

#include "ui/chart/chart_curve.h"
#include "ui/chart/charted_run.h"

namespace core {
struct Scene;
}

namespace ui {

struct Theme;

/// What charts are about: runs of one scene, and which of its weights. What it points to
/// must outlive every chart that shows it.
struct ChartSubject {
  std::vector<ChartedRun> runs;
  const core::Scene* scene = nullptr;  ///< only needed for weights
  std::vector<int> weights;            ///< in charts of single weights; only those followed
  /// Place of the first of the runs among the window's: decides marks, colors and dashes.
  std::size_t firstRun = 0;
};

/// What an axis measures.
struct ChartAxis {
  QString quantity;      ///< "Energy"
  QString unit;          ///< "J"
  bool prefixed = true;  ///< whether the unit may become kJ or mJ
};

/// What a chart of some kind shows of a subject.
struct ChartContent {
  ChartAxis horizontal;
  ChartAxis vertical;
  bool overTime = true;     ///< the horizontal axis is time
  bool energies = false;    ///< the vertical axis is energy of whole runs
  bool endsOnTicks = true;  ///< else where the curves end
  bool equalUnits = false;  ///< a unit is as wide as it is high, where that leaves room
  bool fromZero = false;    ///< the vertical axis begins at zero or below
  std::vector<ChartCurve> curves;
  QString note;  ///< what the reader must know, below the legend
};

}  // namespace ui
