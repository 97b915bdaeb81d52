#include "ui/chart/chart_overlay.h"

#include <algorithm>
#include <vector>

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include "ui/chart/chart_plot.h"
#include "ui/chart/chart_readings.h"
#include "ui/chart/curves_item.h"
#include "ui/style/theme.h"

namespace ui {

namespace {

constexpr double kDotRadius = 5;
constexpr double kCursorWidth = 2;
constexpr double kGap = 8;
constexpr double kGripSize = 7;
constexpr double kSwatch = 14;  // a piece of the curve before its name
constexpr double kSwatchWidth = 3;

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::ChartOverlay)
};

/// The readings as a table: a row for each name, a column for each run.
class ReadingTable {
 public:
  ReadingTable(const std::vector<ChartReading>& readings, const ChartPlot& plot, const QFont& font,
               const QString& title, double mostHeight)
      : m_metrics(font), m_title(title), m_runs(plot.subject().runs.size()) {
    for (const ChartReading& reading : readings) add(reading);
    const auto room =
        static_cast<std::size_t>(std::max(1.0, (mostHeight - 2 * kGap) / m_metrics.height() - 1));
    if (m_rows.size() > room) leaveOutAllBut(room - 1);
    measure();
  }

  QSizeF size() const {
    double width = kGap + m_nameWidth;
    for (const double column : m_widths) width += kGap + column;
    const double titleWidth = m_metrics.horizontalAdvance(m_title) + 2 * kGap;
    return {std::max(width + kGap, titleWidth),
            m_metrics.height() * static_cast<double>(m_rows.size() + 1) + kGap};
  }

  void paint(QPainter& painter, const QRectF& place, const Theme& theme) const {
    QRectF line(place.left() + kGap, place.top() + kGap / 2, place.width() - 2 * kGap,
                m_metrics.height());
    painter.setPen(theme.text);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, m_title);
    for (const Row& row : m_rows) {
      line.translate(0, m_metrics.height());
      paintName(painter, line, row, theme);
      paintCells(painter, line, row, theme);
    }
  }

 private:
  struct Row {
    QString name;
    QColor color;
    std::vector<QString> texts;  // one for each run
  };

  void add(const ChartReading& reading) {
    auto row = std::ranges::find(m_rows, reading.name, &Row::name);
    if (row == m_rows.end()) {
      m_rows.push_back({reading.name, reading.color, std::vector<QString>(m_runs)});
      row = m_rows.end() - 1;
    }
    row->texts[reading.run] = reading.text;
  }

  void leaveOutAllBut(std::size_t kept) {
    const auto rest = static_cast<int>(m_rows.size() - kept);
    const QColor color = m_rows.front().color;
    m_rows.resize(kept);
    m_rows.push_back({Words::tr("… and %1 more").arg(rest), color, std::vector<QString>(m_runs)});
  }

  void measure() {
    m_widths.assign(m_runs, 0);
    for (const Row& row : m_rows) {
      const double name = kSwatch + kGap + m_metrics.horizontalAdvance(row.name);
      m_nameWidth = std::max(m_nameWidth, name);
      for (std::size_t i = 0; i < m_runs; ++i) {
        m_widths[i] = std::max(m_widths[i], m_metrics.horizontalAdvance(row.texts[i]));
      }
    }
  }

  /// In the color of text: thin letters need more contrast than curves have.
  static void paintName(QPainter& painter, const QRectF& line, const Row& row, const Theme& theme) {
    const QPointF start(line.left(), line.center().y());
    painter.setPen(QPen(row.color, kSwatchWidth));
    painter.drawLine(start, start + QPointF(kSwatch, 0));
    painter.setPen(theme.text);
    painter.drawText(line.adjusted(kSwatch + kGap, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     row.name);
  }

  void paintCells(QPainter& painter, const QRectF& line, const Row& row, const Theme& theme) const {
    double x = line.left() + m_nameWidth;
    painter.setPen(theme.text);
    for (std::size_t i = 0; i < m_runs; ++i) {
      const QRectF cell(x + kGap, line.top(), m_widths[i], line.height());
      painter.drawText(cell, Qt::AlignRight | Qt::AlignVCenter, row.texts[i]);
      x = cell.right();
    }
  }

  QFontMetricsF m_metrics;
  QString m_title;
  std::size_t m_runs;
  std::vector<Row> m_rows;
  std::vector<double> m_widths;
  double m_nameWidth = 0;
};

bool isInPlot(const ChartPlot& plot, const QRectF& plotArea, double time) {
  const QTransform toPlot = plotTransform(plot.range(), plotArea);
  const double x = toPlot.map(QPointF(time, 0)).x();
  return plotArea.left() - 1 <= x && x <= plotArea.right() + 1;
}

void paintTimeLine(QPainter& painter, const ChartPlot& plot, const QRectF& plotArea, double time,
                   const QPen& pen) {
  const double x = plotTransform(plot.range(), plotArea).map(QPointF(time, 0)).x();
  painter.setPen(pen);
  painter.drawLine(QPointF(x, plotArea.top()), QPointF(x, plotArea.bottom()));
}

/// A handle at the top of the line, to show that it can be dragged.
void paintGrip(QPainter& painter, const ChartPlot& plot, const QRectF& plotArea, double time,
               const QColor& color) {
  const double x = plotTransform(plot.range(), plotArea).map(QPointF(time, 0)).x();
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawPolygon(QPolygonF({QPointF(x - kGripSize, plotArea.top() - kGripSize),
                                 QPointF(x + kGripSize, plotArea.top() - kGripSize),
                                 QPointF(x, plotArea.top() + kGripSize / 2)}));
}

void paintDots(QPainter& painter, const std::vector<ChartReading>& readings, const ChartPlot& plot,
               const QRectF& plotArea, const Theme& theme) {
  const QTransform toPlot = plotTransform(plot.range(), plotArea);
  for (const ChartReading& reading : readings) {
    const QPointF place = toPlot.map(reading.place);
    if (!plotArea.adjusted(-1, -1, 1, 1).contains(place)) continue;
    const bool isFilled = plot.subject().firstRun + reading.run == 0;
    painter.setPen(QPen(isFilled ? theme.room : reading.color, 1.5));
    painter.setBrush(isFilled ? reading.color : theme.room);
    painter.drawEllipse(place, kDotRadius, kDotRadius);
  }
}

void paintReadings(QPainter& painter, const std::vector<ChartReading>& readings,
                   const ChartOverlay& overlay, const ChartPlot& plot, const QRectF& plotArea,
                   const Theme& theme) {
  // Over the numbers of the time axis, too.
  const double bottom = plotArea.bottom() + 1.3 * QFontMetricsF(painter.font()).height();
  const ReadingTable table(readings, plot, painter.font(), momentText(*overlay.readTime), bottom);
  QRectF box(overlay.pointer + QPointF(2 * kGap, 2 * kGap), table.size());
  // On the other side of the pointer where this one has no room.
  if (box.right() > plotArea.right()) box.moveRight(overlay.pointer.x() - 2 * kGap);
  if (box.left() < plotArea.left()) box.moveLeft(plotArea.left());
  box.moveBottom(std::min(box.bottom(), bottom));
  box.moveTop(std::max(box.top(), 1.0));
  QColor background = theme.room;
  background.setAlphaF(0.93F);
  painter.setPen(QPen(theme.faintText, 1));
  painter.setBrush(background);
  painter.drawRoundedRect(box, 4, 4);
  table.paint(painter, box, theme);
}

}  // namespace

void paintOverlay(QPainter& painter, const ChartOverlay& overlay, const ChartPlot& plot,
                  const QRectF& plotArea, const Theme& theme) {
  painter.setRenderHint(QPainter::Antialiasing);
  const bool overTime = plot.content().overTime;
  if (overlay.shownTime) {
    if (overTime && isInPlot(plot, plotArea, *overlay.shownTime)) {
      paintTimeLine(painter, plot, plotArea, *overlay.shownTime, QPen(theme.text, kCursorWidth));
      paintGrip(painter, plot, plotArea, *overlay.shownTime, theme.text);
    }
    if (!overTime) {
      paintDots(painter, readingsAt(plot, *overlay.shownTime), plot, plotArea, theme);
    }
  }
  if (overlay.readTime) {
    const auto readings = readingsAt(plot, *overlay.readTime);
    if (overTime) {
      paintTimeLine(painter, plot, plotArea, *overlay.readTime,
                    QPen(theme.faintText, 1, Qt::DashLine));
    }
    paintDots(painter, readings, plot, plotArea, theme);
    if (!readings.empty()) paintReadings(painter, readings, overlay, plot, plotArea, theme);
  }
  if (!overlay.box.isEmpty()) {
    QColor inside = theme.potential;
    inside.setAlphaF(0.15F);
    painter.setPen(QPen(theme.potential, 1));
    painter.setBrush(inside);
    painter.drawRect(overlay.box);
  }
}

}  // namespace ui
