#include "ui/chart/step_plot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QChart>
#include <QEvent>
#include <QLineSeries>
#include <QPainter>

#include "ui/chart/chart_content.h"
#include "ui/chart/chart_scales.h"
#include "ui/chart/line_series.h"
#include "ui/style/stage_color.h"

namespace ui {

namespace {

constexpr QSize kLeastSize(270, 120);
constexpr double kArrowShare = 0.35;  // of the step that an arrow spans where there are several
constexpr double kShaft = 2.5;        // [px]
constexpr double kHead = 10;          // [px]
constexpr double kDot = 4;            // radius [px]

void paintArrow(QPainter& painter, QPointF from, QPointF to, const QColor& color) {
  const QLineF line(from, to);
  if (line.length() < 1) return;
  const QPointF along = (to - from) / line.length();
  const QPointF across(-along.y(), along.x());
  const QPointF base = to - kHead * along;
  painter.setPen(QPen(color, kShaft, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(from, base);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawPolygon(QPolygonF{{to, base + 0.45 * kHead * across, base - 0.45 * kHead * across}});
}

/// Holds all values of the step.
void include(double value, double& lowest, double& highest) {
  if (!std::isfinite(value)) return;
  lowest = std::min(lowest, value);
  highest = std::max(highest, value);
}

}  // namespace

StepPlot::StepPlot(QWidget* parent)
    : QChartView(new QChart, parent), m_frame(new ChartFrame(chart())) {
  setRenderHint(QPainter::Antialiasing);
  setFrameShape(QFrame::NoFrame);
  setMinimumSize(kLeastSize);
  setAccessibleName(tr("The step against time"));
  setAccessibleDescription(tr("The exact way, the slopes that the method took, and its end"));
  setFocusPolicy(Qt::NoFocus);  // there is nothing to do with keys
  m_exact = addLineSeries(chart());
  connect(m_frame, &ChartFrame::resized, this, &StepPlot::draw);
  readLook();
}

StepPlot::~StepPlot() {
  // The chart goes after this object's own members are gone.
  disconnect(m_frame, nullptr, this, nullptr);
}

void StepPlot::showStep(PlottedStep step) {
  m_step = std::move(step);
  draw();
}

QPointF StepPlot::arrowTip(const PlottedSlope& slope) const {
  const double span = m_step.duration * (m_step.slopes.size() == 1 ? 1 : kArrowShare);
  return slope.at + QPointF(span, span * slope.slope);
}

void StepPlot::draw() {
  const Theme& theme = m_frame->look().theme;
  HeadingContent heading;
  for (std::size_t i = 0; i < m_step.slopes.size(); ++i) {
    HeadingEntry entry;
    entry.line = QPen(stageColor(i, theme), kShaft);
    entry.text = m_step.slopes[i].name;
    heading.legend.push_back(entry);
  }
  if (m_step.duration > 0) {
    HeadingEntry exact;
    exact.line = QPen(theme.faintText, 2);
    exact.text = tr("exact");
    heading.legend.push_back(exact);
  }
  m_frame->setHeading(std::move(heading));
  m_exact->setPen(QPen(theme.faintText, 2));
  m_exact->replace(m_step.exact);
  if (m_step.duration > 0) {
    double lowest = m_step.start.y(), highest = lowest, last = m_step.start.x() + m_step.duration;
    for (const QPointF& point : m_step.exact) include(point.y(), lowest, highest);
    for (const PlottedEnd& end : m_step.ends) include(end.at.y(), lowest, highest);
    for (const PlottedSlope& slope : m_step.slopes) {
      include(slope.at.y(), lowest, highest);
      include(arrowTip(slope).y(), lowest, highest);
      last = std::max(last, arrowTip(slope).x());
    }
    // Where nothing changes the scale must still have a height.
    const double room = std::max(0.06 * (highest - lowest), 1e-9 * (1 + std::abs(highest)));
    const ChartAxis time{.quantity = tr("Time"), .unit = tr("s"), .prefixed = false};
    const ChartAxis value{.quantity = m_step.quantity, .unit = m_step.unit, .prefixed = false};
    m_frame->setHorizontal(
        axisScale(time, m_step.start.x(), last, m_frame->horizontalIntervals(), AxisEnds::kOnTicks),
        time.quantity);
    m_frame->setVertical(axisScale(value, lowest - room, highest + room,
                                   m_frame->verticalIntervals(), AxisEnds::kOnTicks),
                         value.quantity);
  }
  viewport()->update();
}

QPointF StepPlot::placeOf(QPointF value) const {
  return chart()->mapToPosition(value, m_exact);
}

void StepPlot::drawForeground(QPainter* painter, const QRectF& rect) {
  QChartView::drawForeground(painter, rect);
  if (!(m_step.duration > 0)) return;
  const Theme& theme = m_frame->look().theme;
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setFont(m_frame->look().font);
  for (std::size_t i = 0; i < m_step.slopes.size(); ++i) {
    const QColor color = stageColor(i, theme);
    const QPointF place = placeOf(m_step.slopes[i].at);
    paintArrow(*painter, place, placeOf(arrowTip(m_step.slopes[i])), color);
    painter->setPen(Qt::NoPen);
    painter->setBrush(color);
    painter->drawEllipse(place, kDot, kDot);
  }
  painter->setBrush(Qt::NoBrush);
  painter->setPen(QPen(theme.text, 2));
  for (const PlottedEnd& end : m_step.ends) {
    const QPointF place = placeOf(end.at);
    painter->drawEllipse(place, 1.5 * kDot, 1.5 * kDot);
  }
  painter->restore();
}

void StepPlot::changeEvent(QEvent* event) {
  QChartView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) readLook();
}

void StepPlot::readLook() {
  const Theme theme = Theme::of(palette());
  setBackgroundBrush(theme.background);
  m_frame->setLook(ChartLook::forScreen(theme, font()));
  draw();
}

}  // namespace ui
