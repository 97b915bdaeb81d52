#pragma once

#include <vector>

#include <QSizeF>
#include <QString>

#include "ui/chart/charted_run.h"

namespace ui {

/// Words that go with an exported chart.
struct ChartCaption {
  QString title;  ///< scene name
  QString note;   ///< methods and steps; may be empty: then the runs' names are used
};

/// Writes the energy chart for paper (light, whatever the window looks like) as PNG, SVG or
/// PDF by the file's ending; needs no display. PNG: twice the pixels, 300 dpi. Carries
/// title, units, method, step and scene name. Never leaves a half-written file.
///
/// @param size  in mm on paper
/// @return      empty, or what went wrong in words
QString writeEnergyChart(const QString& file, const std::vector<ChartedRun>& runs,
                         const ChartCaption& caption, QSizeF size = QSizeF(160, 100));

}  // namespace ui
