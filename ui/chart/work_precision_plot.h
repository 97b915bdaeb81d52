#pragma once

#include <memory>
#include <vector>

#include <QGraphicsSimpleTextItem>
#include <QObject>
#include <QString>

#include "core/trade/measurement.h"
#include "ui/chart/label_places.h"
#include "ui/chart/log_frame.h"

class QChart;

namespace ui {

/// What a work–precision chart shows errors against.
enum class ErrorAgainst { kCost, kStep };

/// Errors of methods against their cost, or against their step with guides of slope 1 and 4;
/// each line with the order that was observed. The same on screen and on paper. Belongs to its
/// chart as a child object.
class WorkPrecisionPlot : public QObject {
  Q_OBJECT

 public:
  /// @param chart  takes ownership
  explicit WorkPrecisionPlot(QChart* chart);

  void setLook(const ChartLook& look);
  void setTitle(const QString& title);
  void setAgainst(ErrorAgainst against);
  /// Null: an empty chart.
  void setMeasurement(std::shared_ptr<const core::Measurement> measurement);

 signals:
  /// The user clicked a point.
  void pointPicked(const core::Solver& solver);

 private:
  struct Label {
    QGraphicsSimpleTextItem* text;  // owned by the chart
    std::vector<QPointF> curve;     // in logarithms
  };

  void update();
  void showScales();
  void showCurve(const core::MethodCurve& curve, const QColor& color);
  void showGuide(int slope);
  void addLabel(const QString& words, const QColor& color, std::vector<QPointF> curve);
  void placeLabels();
  QPointF placeOf(const core::MeasuredPoint& point) const;

  QChart* m_chart;    // the parent
  LogFrame* m_frame;  // belongs to the chart
  QString m_title;
  ErrorAgainst m_against = ErrorAgainst::kCost;
  std::shared_ptr<const core::Measurement> m_measurement;
  std::vector<Label> m_labels;
  QRectF m_extent;  // of all points, in logarithms, lowest error as top()
};

}  // namespace ui
