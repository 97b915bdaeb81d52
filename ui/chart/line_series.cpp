#include "ui/chart/line_series.h"

#include <QAbstractAxis>
#include <QChart>
#include <QLineSeries>

namespace ui {

QLineSeries* addLineSeries(QChart* chart) {
  auto* series = new QLineSeries;
  chart->addSeries(series);
  for (QAbstractAxis* axis : chart->axes()) series->attachAxis(axis);
  return series;
}

}  // namespace ui
