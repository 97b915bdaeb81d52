#pragma once

#include <optional>
#include <vector>

#include <QImage>
#include <QRectF>
#include <QSizeF>
#include <QString>

#include "ui/chart/chart_content.h"
#include "ui/chart/hidden_curves.h"

namespace ui {

struct ChartKind;

/// A chart as somebody looks at it.
struct ChartPicture {
  const ChartKind* kind = nullptr;
  ChartSubject subject;
  HiddenCurves hidden;
  std::optional<QRectF> zoom;  ///< in SI units, lowest y as top(); nothing: all
};

/// Words that go with an exported chart.
struct ChartCaption {
  QString title;  ///< scene name
  QString note;   ///< methods and steps; may be empty: then the runs' names are used
};

/// The size of an exported chart unless another is chosen, in mm on paper.
inline constexpr QSizeF kUsualChartSize(160, 100);

/// Writes a chart for paper (light, whatever the window looks like) as PNG, SVG or PDF by the
/// file's ending; needs no display. PNG: twice the pixels, 300 dpi. Carries title, units,
/// method, step and scene name. Never leaves a half-written file.
///
/// @param size  in mm on paper
/// @return      empty, or what went wrong in words
QString writeChartPicture(const QString& file, const ChartPicture& picture,
                          const ChartCaption& caption, QSizeF size = kUsualChartSize);

/// The same as pixels, at 300 dpi.
QImage chartImage(const ChartPicture& picture, const ChartCaption& caption,
                  QSizeF size = kUsualChartSize);

/// The energies of runs over time, as a file.
QString writeEnergyChart(const QString& file, const std::vector<ChartedRun>& runs,
                         const ChartCaption& caption, QSizeF size = kUsualChartSize);

}  // namespace ui
