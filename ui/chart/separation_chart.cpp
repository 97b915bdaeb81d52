#include "ui/chart/separation_chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QChart>
#include <QEvent>
#include <QLineSeries>

#include "ui/chart/chart_content.h"
#include "ui/chart/chart_scales.h"
#include "ui/chart/curve_pieces.h"
#include "ui/chart/line_series.h"
#include "ui/chart/run_pen.h"

namespace ui {

namespace {

constexpr double kLeastTime = 2;  // [s]
constexpr double kWidth = 2.5;    // [px]
constexpr std::size_t kMostPoints = 4000;
constexpr QSize kLeastSize(200, 120);

/// Thinned, in the units of the axes.
QList<QPointF> pointsOf(const core::SeparationSeries& series, std::size_t most,
                        double distanceUnit) {
  std::vector<core::TimedPoint> all;
  all.reserve(series.samples().size());
  for (const core::Separation& sample : series.samples())
    if (std::isfinite(sample.distance)) all.push_back({sample.time, sample.time, sample.distance});
  QList<QPointF> points;
  for (const core::TimedPoint& point : core::thinned(all, most))
    points.append({point.x, point.y / distanceUnit});
  return points;
}

}  // namespace

SeparationChart::SeparationChart(QWidget* parent)
    : QChartView(new QChart, parent), m_frame(new ChartFrame(chart())) {
  setRenderHint(QPainter::Antialiasing);
  setFrameShape(QFrame::NoFrame);
  setMinimumSize(kLeastSize);
  setAccessibleName(tr("Distance between the runs over time"));
  setAccessibleDescription(
      tr("Largest distance between the same weight in both runs, in m, on a logarithmic axis"));
  setFocusPolicy(Qt::NoFocus);  // there is nothing to do with keys
  connect(m_frame, &ChartFrame::resized, this, &SeparationChart::refresh);
  readLook();
}

SeparationChart::~SeparationChart() {
  // The chart goes after this object's own members are gone.
  disconnect(m_frame, nullptr, this, nullptr);
}

void SeparationChart::setCurves(std::vector<SeparationCurve> curves) {
  m_curves = std::move(curves);
  chart()->removeAllSeries();
  m_lines.clear();
  for (const SeparationCurve& curve : m_curves) {
    m_lines.push_back(addLineSeries(chart()));
    m_lines.back()->setName(curve.name);
  }
  refresh();
}

double SeparationChart::lastTime() const {
  double last = kLeastTime;
  for (const SeparationCurve& curve : m_curves)
    if (!curve.series->samples().empty())
      last = std::max(last, curve.series->samples().back().time);
  return last;
}

double SeparationChart::largestDistance() const {
  double largest = 0;
  for (const SeparationCurve& curve : m_curves)
    for (const core::Separation& sample : curve.series->samples())
      if (std::isfinite(sample.distance)) largest = std::max(largest, sample.distance);
  return largest;
}

void SeparationChart::refresh() {
  const ChartAxis time{.quantity = tr("Time"), .unit = tr("s"), .prefixed = false};
  const ChartAxis distance{.quantity = tr("Distance"), .unit = tr("m")};
  const AxisScale across =
      axisScale(time, 0, lastTime(), m_frame->horizontalIntervals(), AxisEnds::kOnTicks);
  const AxisScale up =
      axisScale(distance, 0, largestDistance(), m_frame->verticalIntervals(), AxisEnds::kOnTicks);
  m_frame->setHorizontal(across, time.quantity);
  m_frame->setVertical(up, distance.quantity);
  const QSizeF plot = m_frame->plotSize();
  const QSizeF unitSize(plot.width() / (across.highest - across.lowest),
                        plot.height() / (up.highest - up.lowest));
  const std::size_t most = mostPointsPerCurve(m_curves.size(), kMostPoints);
  const Theme& theme = m_frame->look().theme;
  for (std::size_t i = 0; i < m_curves.size(); ++i) {
    const std::size_t place = m_curves[i].place;
    const QList<QPointF> points = pointsOf(*m_curves[i].series, most, up.unit.size);
    const QColor& color = theme.runs[place % theme.runs.size()];
    const bool dense = isTooDenseForDashes(points, unitSize);
    m_lines[i]->setPen(dense ? densePen(color) : runPen(color, kWidth, place));
    m_lines[i]->replace(points);
  }
}

void SeparationChart::changeEvent(QEvent* event) {
  QChartView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) readLook();
}

void SeparationChart::readLook() {
  const Theme theme = Theme::of(palette());
  setBackgroundBrush(theme.background);
  m_frame->setLook(ChartLook::forScreen(theme, font()));
  refresh();
}

}  // namespace ui
