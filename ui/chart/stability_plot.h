#pragma once

#include <memory>

#include <QGraphicsItem>
#include <QObject>
#include <QString>

#include "core/trade/stability_map.h"
#include "ui/chart/log_frame.h"

class QChart;

namespace ui {

/// A stability map as colored cells, step × rope length or air density, with a legend: bounded
/// in three grades of drift, runaway, diverged; cells whose scene cannot be are empty. The same
/// on screen and on paper. Belongs to its chart as a child object.
class StabilityPlot : public QObject {
  Q_OBJECT

 public:
  /// @param chart  takes ownership
  explicit StabilityPlot(QChart* chart);
  ~StabilityPlot() override;

  void setLook(const ChartLook& look);
  void setTitle(const QString& title);
  /// Null: an empty chart.
  void setMap(std::shared_ptr<const core::StabilityMap> map);

 private:
  class Cells;

  void update();
  void showScales();
  void placeCells();

  QChart* m_chart;    // the parent
  LogFrame* m_frame;  // belongs to the chart
  Cells* m_cells;     // owned by the chart
  QString m_title;
  std::shared_ptr<const core::StabilityMap> m_map;
};

/// Writes the map for paper as PNG, SVG or PDF by the file's ending; needs no display.
///
/// @param title  scene name
/// @return       empty, or what went wrong in words
QString writeStabilityChart(const QString& file, std::shared_ptr<const core::StabilityMap> map,
                            const QString& title);

}  // namespace ui
