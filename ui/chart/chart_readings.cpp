#include "ui/chart/chart_readings.h"

#include <cmath>

#include <QCoreApplication>
#include <QLocale>

#include "ui/chart/chart_plot.h"
#include "ui/chart/figure_text.h"

namespace ui {

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::ChartReadings)
};

QString withUnit(double value, const QString& unit) {
  const bool isDegrees = unit == QStringLiteral("°");
  return figure(value) + (isDegrees ? QString() : QString(QChar::Nbsp)) + unit;
}

/// @param amount  what is read off there
QString textOf(const ChartContent& content, const core::TimedPoint& point, double amount) {
  QString y = withUnit(amount, content.vertical.unit);
  if (content.overTime) return y;
  return Words::tr("%1; %2").arg(withUnit(point.x, content.horizontal.unit), y);
}

}  // namespace

std::vector<ChartReading> readingsAt(const ChartPlot& plot, double time) {
  std::vector<ChartReading> readings;
  const ChartContent& content = plot.content();
  for (std::size_t i = 0; i < content.curves.size(); ++i) {
    if (!plot.isShown(i)) continue;
    const auto point = plot.caches()[i].at(time);
    const auto amount = plot.readable(i).at(time);
    if (!point || !amount) continue;
    const ChartCurve& curve = content.curves[i];
    const double shift = curve.holdsPotential ? plot.offset() : 0;
    readings.push_back({curve.name, curve.run, curve.color, QPointF(point->x, point->y - shift),
                        textOf(content, *point, amount->y)});
  }
  return readings;
}

std::optional<double> nearestTime(const ChartPlot& plot, QPointF place, QSizeF unitSize,
                                  double most) {
  std::optional<double> nearest;
  double least = most;
  for (std::size_t i = 0; i < plot.caches().size(); ++i) {
    if (!plot.isShown(i)) continue;
    for (const core::TimedPoint& point : plot.caches()[i].points()) {
      const double distance = std::hypot((point.x - place.x()) * unitSize.width(),
                                         (point.y - place.y()) * unitSize.height());
      if (!(distance < least)) continue;  // gaps neither
      least = distance;
      nearest = point.time;
    }
  }
  return nearest;
}

QString momentText(double time) {
  return Words::tr("%1 s").arg(QLocale().toString(time, 'f', 3));
}

}  // namespace ui
