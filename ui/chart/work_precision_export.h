#pragma once

#include <memory>

#include <QSizeF>
#include <QString>

#include "core/trade/measurement.h"
#include "ui/chart/work_precision_plot.h"

namespace ui {

/// Writes the chart for paper as PNG, SVG or PDF by the file's ending; needs no display. Never
/// leaves a half-written file.
///
/// @param title  scene name
/// @param size   in mm on paper
/// @return       empty, or what went wrong in words
QString writeWorkPrecisionChart(const QString& file,
                                std::shared_ptr<const core::Measurement> measurement,
                                ErrorAgainst against, const QString& title,
                                QSizeF size = QSizeF(200, 125));

}  // namespace ui
