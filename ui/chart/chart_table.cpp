#include "ui/chart/chart_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <QCoreApplication>
#include <QLocale>

#include "ui/chart/chart_plot.h"

namespace ui {

namespace {

using core::TimedPoint;

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::ChartTable)
};

/// One column: a heading, and what to take of each point.
struct Column {
  QString heading;
  std::span<const TimedPoint> points;
  double TimedPoint::*value;
};

std::span<const TimedPoint> pointsShown(const ChartPlot& plot, std::size_t curve) {
  const std::span<const TimedPoint> all = plot.readable(curve).points();
  if (!plot.content().overTime) return all;
  const auto begin = std::ranges::lower_bound(all, plot.range().left(), {}, &TimedPoint::time);
  const auto end = std::ranges::upper_bound(all, plot.range().right(), {}, &TimedPoint::time);
  return {begin, end};
}

QString heading(const ChartPlot& plot, const ChartCurve& curve, const QString& name,
                const QString& unit) {
  return Words::tr("%1 (%2), %3").arg(name, unit, plot.subject().runs[curve.run].name);
}

void appendColumns(std::vector<Column>& columns, const ChartPlot& plot, std::size_t index) {
  const ChartContent& content = plot.content();
  const ChartCurve& curve = content.curves[index];
  const auto points = pointsShown(plot, index);
  if (content.overTime) {
    columns.push_back(
        {heading(plot, curve, curve.name, content.vertical.unit), points, &TimedPoint::y});
    return;
  }
  const auto named = [&](const ChartAxis& axis) {
    return heading(plot, curve, curve.name + QStringLiteral(": ") + axis.quantity, axis.unit);
  };
  columns.push_back({named(content.horizontal), points, &TimedPoint::x});
  columns.push_back({named(content.vertical), points, &TimedPoint::y});
}

std::vector<Column> columnsOf(const ChartPlot& plot) {
  std::vector<Column> columns;
  for (std::size_t run = 0; run < plot.subject().runs.size(); ++run) {
    bool isFirst = true;
    for (std::size_t i = 0; i < plot.content().curves.size(); ++i) {
      const ChartCurve& curve = plot.content().curves[i];
      if (curve.run != run || !plot.isShown(i)) continue;
      if (isFirst) {
        columns.push_back({heading(plot, curve, Words::tr("Time"), Words::tr("s")),
                           pointsShown(plot, i), &TimedPoint::time});
      }
      isFirst = false;
      appendColumns(columns, plot, i);
    }
  }
  return columns;
}

/// In the fewest digits that read back to the same double; empty in gaps.
QString number(double value, const QString& decimalPoint) {
  if (!std::isfinite(value)) return {};
  QString text = QString::number(value, 'g', QLocale::FloatingPointShortest);
  return text.replace('.', decimalPoint);
}

/// Quoted where the separator, or a quote, stands in it (RFC 4180).
QString field(QString text, QChar separator) {
  if (!text.contains(separator) && !text.contains('"')) return text;
  return '"' + text.replace('"', QStringLiteral("\"\"")) + '"';
}

}  // namespace

QString chartTable(const ChartPlot& plot, QChar separator, const QString& decimalPoint) {
  const std::vector<Column> columns = columnsOf(plot);
  QStringList cells;
  std::size_t rows = 0;
  for (const Column& column : columns) {
    cells << field(column.heading, separator);
    rows = std::max(rows, column.points.size());
  }
  QString table = cells.join(separator) + '\n';
  for (std::size_t row = 0; row < rows; ++row) {
    cells.clear();
    for (const Column& column : columns) {
      cells << (row < column.points.size()
                    ? field(number(column.points[row].*column.value, decimalPoint), separator)
                    : QString());
    }
    table += cells.join(separator) + '\n';
  }
  return table;
}

}  // namespace ui
