#include "ui/chart/chart_frame.h"

#include <algorithm>
#include <utility>

#include <QChart>
#include <QGraphicsLayout>
#include <QLegend>
#include <QLineSeries>
#include <QLocale>
#include <QValueAxis>

namespace ui {

namespace {

void showScale(QValueAxis& axis, const NiceScale& scale, const QString& title) {
  axis.setLabelFormat(QStringLiteral("%.%1f").arg(scale.decimals()));
  axis.setTickCount(scale.tickCount());
  axis.setRange(scale.lowest, scale.highest);
  axis.setTitleText(title);
}

// Around everything, in multiples of the font's size.
constexpr double kPadding = 0.7;

}  // namespace

ChartFrame::ChartFrame(QChart* chart)
    : QObject(chart),
      m_chart(chart),
      m_horizontal(addAxis(Qt::AlignBottom)),
      m_vertical(addAxis(Qt::AlignLeft)),
      m_heading(new ChartHeading(chart)) {
  chart->legend()->hide();
  chart->layout()->setContentsMargins(0, 0, 0, 0);
  // Else the chart keeps the size that a heading in a narrower chart made it need.
  chart->setMinimumSize(1, 1);
  chart->setLocalizeNumbers(true);
  chart->setLocale(QLocale());
  connect(chart, &QChart::geometryChanged, this, [this] {
    layOut();
    emit resized();
  });
}

QValueAxis* ChartFrame::addAxis(Qt::Alignment side) {
  auto* axis = new QValueAxis;
  m_chart->addAxis(axis, side);
  return axis;
}

void ChartFrame::setLook(const ChartLook& look) {
  m_look = look;
  applyLook(*m_chart, look);
  applyLook(*m_horizontal, look);
  applyLook(*m_vertical, look);
  m_heading->setLook(look);
  layOut();
}

void ChartFrame::setHeading(HeadingContent content) {
  m_heading->setContent(std::move(content));
  layOut();
}

void ChartFrame::setHorizontal(const NiceScale& scale, const QString& title) {
  showScale(*m_horizontal, scale, title);
}

void ChartFrame::setVertical(const NiceScale& scale, const QString& title) {
  showScale(*m_vertical, scale, title);
}

QLineSeries* ChartFrame::addCurve(const QString& name) {
  auto* curve = new QLineSeries;
  curve->setName(name);
  m_chart->addSeries(curve);
  curve->attachAxis(m_horizontal);
  curve->attachAxis(m_vertical);
  return curve;
}

void ChartFrame::removeCurves() {
  m_chart->removeAllSeries();
}

int ChartFrame::horizontalIntervals() const {
  constexpr double kLabel = 5.5;  // in multiples of the font's size, with room beside it
  const double labels = plotSize().width() / (kLabel * m_look.font.pixelSize());
  return std::clamp(static_cast<int>(labels), 1, 10);
}

int ChartFrame::verticalIntervals() const {
  constexpr double kLabel = 2.2;
  const double labels = plotSize().height() / (kLabel * m_look.font.pixelSize());
  return std::clamp(static_cast<int>(labels), 1, 8);
}

QSizeF ChartFrame::unitSize() const {
  const QSizeF size = plotSize();
  return {size.width() / (m_horizontal->max() - m_horizontal->min()),
          size.height() / (m_vertical->max() - m_vertical->min())};
}

/// Before the chart has laid itself out, from what stands around the plot.
QSizeF ChartFrame::plotSize() const {
  constexpr QSizeF kAxes(5, 4);  // in multiples of the font's size
  const QMarginsF margins = m_chart->margins();
  return m_chart->size().shrunkBy(margins) - kAxes * m_look.font.pixelSize();
}

void ChartFrame::layOut() {
  const int padding = qRound(kPadding * m_look.font.pixelSize());
  m_heading->setPos(padding, padding);
  const double height = m_heading->layOut(m_chart->size().width() - 2 * padding);
  // On the right half a label stands out over the last tick.
  const QMargins margins(padding, qRound(height) + 3 * padding / 2, 2 * padding, padding);
  if (m_chart->margins() != margins) m_chart->setMargins(margins);
}

}  // namespace ui
