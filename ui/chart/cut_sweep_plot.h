#pragma once

#include <memory>
#include <optional>

#include <QImage>
#include <QObject>
#include <QRectF>
#include <QString>
#include <QTransform>

#include "ui/chart/chart_frame.h"
#include "ui/chart/cut_sweep_result.h"

class QChart;

namespace ui {

class CurvesItem;

/// Landing place against cut time, in pieces that differ by what was hit before; the target as a
/// band, and on it the stretches that hit, each with the moment that comes nearest to its center.
/// The same on screen and on paper. Belongs to its chart as a child object.
class CutSweepPlot : public QObject {
  Q_OBJECT

 public:
  /// @param chart  takes ownership
  explicit CutSweepPlot(QChart* chart);
  ~CutSweepPlot() override;

  void setLook(const ChartLook& look);
  const ChartLook& look() const { return m_frame->look(); }
  /// Null: an empty chart.
  void setResult(std::shared_ptr<const CutSweepResult> result);
  const CutSweepResult* result() const { return m_result.get(); }

  /// From cut time [s] and place [m] to where it stands in the chart [px].
  QTransform toChart() const;

 private:
  class Hits;

  void update();
  void showScales();
  QRectF extent() const;

  QChart* m_chart;       // the parent
  ChartFrame* m_frame;   // belongs to the chart
  CurvesItem* m_curves;  // owned by the chart
  Hits* m_hits;          // owned by the chart
  std::shared_ptr<const CutSweepResult> m_result;
  QRectF m_range{0, 0, 1, 1};  // shown: cut times [s] and places [m], the lowest as top()
};

/// Writes the chart for paper as PNG, SVG or PDF by the file's ending; needs no display. Never
/// leaves a half-written file.
/// @return  empty, or what went wrong in words
QString writeCutSweepChart(const QString& file, std::shared_ptr<const CutSweepResult> result);

/// The same as pixels, at 300 dpi.
QImage cutSweepImage(std::shared_ptr<const CutSweepResult> result);

}  // namespace ui
