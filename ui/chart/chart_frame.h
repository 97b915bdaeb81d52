#pragma once

#include <QMargins>
#include <QObject>
#include <QSizeF>
#include <QString>

#include "ui/chart/chart_heading.h"
#include "ui/chart/chart_look.h"
#include "ui/chart/chart_scales.h"

class QChart;
class QValueAxis;

namespace ui {

/// What every chart of ours has: two axes with titles and nice limits, a heading with a
/// legend above or beside the plot, and a look. Belongs to its chart as a child object.
class ChartFrame : public QObject {
  Q_OBJECT

 public:
  /// @param chart  takes ownership
  explicit ChartFrame(QChart* chart);

  void setLook(const ChartLook& look);
  const ChartLook& look() const { return m_look; }

  void setHeading(HeadingContent content);
  const ChartHeading& heading() const { return *m_heading; }
  void setHorizontal(const AxisScale& scale, const QString& quantity);
  void setVertical(const AxisScale& scale, const QString& quantity);

  /// Most intervals between labels that have room at the present size.
  int horizontalIntervals() const;
  int verticalIntervals() const;
  /// About the size of the plot, also before the chart has laid itself out [px].
  QSizeF plotSize() const;

 signals:
  /// The chart has another size: other scales may fit better.
  void resized();

 private:
  void layOut();
  bool putHeadingBeside(HeadingDensity density);
  double putHeadingAbove();
  void setMargins(const QMargins& margins);
  int padding() const;
  QValueAxis* addAxis(Qt::Alignment side);

  QChart* m_chart;  // the parent
  // Owned by the chart.
  QValueAxis* m_horizontal;
  QValueAxis* m_vertical;
  ChartHeading* m_heading;
  ChartLook m_look;
  bool m_isLow = false;  // no line to spare for the title of the time axis
};

}  // namespace ui
