#pragma once

#include <vector>

#include <QChartView>
#include <QColor>
#include <QString>

#include "core/recording/separation.h"
#include "ui/chart/chart_frame.h"
#include "ui/style/theme.h"

class QLineSeries;

namespace ui {

/// One curve of a separation chart.
struct SeparationCurve {
  const core::SeparationSeries* series = nullptr;
  QString name;
  std::size_t place = 0;  ///< of the run among all runs: decides color and dashes
};

/// How far runs are apart from one of them, over time, on one scale. Draws a record;
/// computes no physics.
class SeparationChart : public QChartView {
  Q_OBJECT

 public:
  explicit SeparationChart(QWidget* parent = nullptr);
  ~SeparationChart() override;

  /// Which curves to draw from now on. The series must outlive the chart or the next call.
  void setCurves(std::vector<SeparationCurve> curves);
  /// Redraws from the series.
  void refresh();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void readLook();
  double lastTime() const;
  double largestDistance() const;

  // Owned by the chart, which this view owns.
  ChartFrame* m_frame;
  std::vector<SeparationCurve> m_curves;
  std::vector<QLineSeries*> m_lines;  // one for each
};

}  // namespace ui
