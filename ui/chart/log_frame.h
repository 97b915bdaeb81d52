#pragma once

#include <QObject>
#include <QRectF>
#include <QString>

#include "ui/chart/chart_heading.h"
#include "ui/chart/chart_look.h"
#include "ui/chart/log_scale.h"

class QCategoryAxis;
class QChart;
class QXYSeries;

namespace ui {

/// What our charts with logarithmic axes have: two axes with titles, a heading, and a look.
/// Curves hold decimal logarithms. Belongs to its chart as a child object.
class LogFrame : public QObject {
  Q_OBJECT

 public:
  /// @param chart  takes ownership
  explicit LogFrame(QChart* chart);

  void setLook(const ChartLook& look);
  const ChartLook& look() const { return m_look; }

  void setHeading(HeadingContent content);
  void setHorizontal(const LogScale& scale, const QString& title);
  void setVertical(const LogScale& scale, const QString& title);

  /// Adds a curve or marks along both axes; the chart takes ownership.
  void add(QXYSeries* series);
  void removeCurves();

  /// Most labels that have room at the present size.
  int horizontalLabels() const;
  int verticalLabels() const;

 signals:
  /// The chart has another size: other scales may fit better.
  void resized();

 private:
  void layOut();
  QCategoryAxis* addAxis(Qt::Alignment side);

  QChart* m_chart;  // the parent
  // Owned by the chart.
  QCategoryAxis* m_horizontal;
  QCategoryAxis* m_vertical;
  ChartHeading* m_heading;
  ChartLook m_look;
};

}  // namespace ui
