#pragma once

#include <optional>

#include <QFont>
#include <QRectF>

class QPainter;

namespace ui {

class ChartPlot;
struct Theme;

/// What moves over a chart while it stays as it is.
struct ChartOverlay {
  std::optional<double> shownTime;  ///< the moment that all views show [s]
  std::optional<double> readTime;   ///< the moment under the pointer [s]
  QPointF pointer;                  ///< [px]
  QRectF box;                       ///< being drawn, to zoom to it; empty: none [px]
};

/// Paints the line or dots at the moment shown, and the values under the pointer.
/// @param plotArea  [px]
void paintOverlay(QPainter& painter, const ChartOverlay& overlay, const ChartPlot& plot,
                  const QRectF& plotArea, const Theme& theme);

}  // namespace ui
