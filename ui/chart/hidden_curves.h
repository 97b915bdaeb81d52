#pragma once

#include <cstddef>
#include <set>

#include <QString>

#include "ui/chart/chart_curve.h"

namespace ui {

/// What the reader has hidden: curves by their names, and whole runs.
struct HiddenCurves {
  std::set<QString> names;
  std::set<std::size_t> runs;

  bool holds(const ChartCurve& curve) const {
    return names.contains(curve.name) || runs.contains(curve.run);
  }
};

}  // namespace ui
