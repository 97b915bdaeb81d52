#pragma once

#include <vector>

#include <QChartView>
#include <QList>
#include <QPointF>
#include <QString>

#include "ui/chart/chart_frame.h"

class QLineSeries;

namespace ui {

/// A slope taken somewhere inside a step.
struct PlottedSlope {
  QString name;
  QPointF at;    ///< time [s], quantity
  double slope;  ///< of the quantity [1/s]
};

/// Where a method ends.
struct PlottedEnd {
  QString name;
  QPointF at;  ///< time [s], quantity
};

/// One quantity of a weight inside one step, in the unit it is shown in.
struct PlottedStep {
  QString quantity;      ///< "θ"
  QString unit;          ///< "°"
  QPointF start;         ///< time [s], quantity
  double duration = 0;   ///< [s], > 0
  QList<QPointF> exact;  ///< the way without a method's error
  std::vector<PlottedSlope> slopes;
  std::vector<PlottedEnd> ends;
};

/// A step against time: the slopes as arrows at the places they were taken, the ends of the
/// methods, and the exact way.
class StepPlot : public QChartView {
  Q_OBJECT

 public:
  explicit StepPlot(QWidget* parent = nullptr);
  ~StepPlot() override;

  void showStep(PlottedStep step);
  void clearStep() { showStep({}); }

 protected:
  void drawForeground(QPainter* painter, const QRectF& rect) override;
  void changeEvent(QEvent* event) override;

 private:
  void readLook();
  void draw();
  QPointF arrowTip(const PlottedSlope& slope) const;
  QPointF placeOf(QPointF value) const;

  // Owned by the chart, which this view owns.
  ChartFrame* m_frame;
  QLineSeries* m_exact;
  PlottedStep m_step;
};

}  // namespace ui
