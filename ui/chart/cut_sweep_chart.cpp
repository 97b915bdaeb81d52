#include "ui/chart/cut_sweep_chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QFontMetricsF>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

namespace ui {
namespace {

constexpr double kNear = 8;  // of a hit [px]
constexpr double kGap = 10;  // [px]
constexpr double kDot = 5;   // [px]

}  // namespace

CutSweepChart::CutSweepChart(QWidget* parent) : TradeView<CutSweepPlot>(parent) {
  setMouseTracking(true);
  // What moves with the pointer is drawn over everything.
  setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
  setAccessibleName(tr("Landing place against cut time"));
  setAccessibleDescription(
      tr("A click cuts the ropes at that moment; moments that hit are listed "
         "in the table beside it."));
}

void CutSweepChart::setResult(std::shared_ptr<const CutSweepResult> result) {
  plot()->setResult(std::move(result));
  viewport()->update();
}

void CutSweepChart::mouseMoveEvent(QMouseEvent* event) {
  m_pointer = event->position();
  viewport()->setCursor(timeAt(*m_pointer) ? Qt::PointingHandCursor : Qt::ArrowCursor);
  viewport()->update();
}

void CutSweepChart::leaveEvent(QEvent* event) {
  m_pointer.reset();
  viewport()->update();
  TradeView<CutSweepPlot>::leaveEvent(event);
}

void CutSweepChart::mousePressEvent(QMouseEvent* event) {
  const auto time = timeAt(event->position());
  if (event->button() != Qt::LeftButton || !time) return;
  if (const core::Hit* hit = hitNear(event->position())) {
    emit momentPicked(hit->best);
  } else {
    // Not finer than a pixel can mean.
    emit momentPicked(std::round(*time * 1000) / 1000);
  }
}

std::optional<double> CutSweepChart::timeAt(QPointF pixel) const {
  if (!plot()->result() || !chart()->plotArea().contains(pixel)) return std::nullopt;
  return plot()->toChart().inverted().map(pixel).x();
}

/// The one whose stretch or best moment is nearest.
const core::Hit* CutSweepChart::hitNear(QPointF pixel) const {
  const QTransform toChart = plot()->toChart();
  const auto x = [&](double time) { return toChart.map(QPointF(time, 0)).x(); };
  const core::Hit* nearest = nullptr;
  double least = kNear;
  for (const core::Hit& hit : plot()->result()->hits) {
    const double distance = std::max({0.0, x(hit.from) - pixel.x(), pixel.x() - x(hit.until)});
    if (distance >= least) continue;
    least = distance;
    nearest = &hit;
  }
  return nearest;
}

const core::Landing* CutSweepChart::landingAt(double time) const {
  const auto& landings = plot()->result()->landings;
  const auto after = std::ranges::lower_bound(landings, time, {}, &core::Landing::cutTime);
  if (after == landings.begin()) return landings.empty() ? nullptr : &landings.front();
  if (after == landings.end()) return nullptr;
  const auto before = std::prev(after);
  return time - before->cutTime < after->cutTime - time ? &*before : &*after;
}

QStringList CutSweepChart::readings(const core::Landing& landing) const {
  QStringList lines{tr("cut at %1 s").arg(cutTimeText(landing.cutTime))};
  if (landing.outcome != core::LandingOutcome::kLanded) return lines << tr("does not land");
  lines << tr("lands at %1 m").arg(QLocale().toString(landing.place, 'f', 3));
  lines << tr("after %1 s").arg(QLocale().toString(landing.time - landing.cutTime, 'f', 3));
  const QString hit = firstHitWords(landing.firstHit);
  if (!hit.isEmpty()) lines << hit;
  return lines;
}

void CutSweepChart::drawForeground(QPainter* painter, const QRectF& rect) {
  TradeView<CutSweepPlot>::drawForeground(painter, rect);
  const auto time = m_pointer ? timeAt(*m_pointer) : std::nullopt;
  const core::Landing* landing = time ? landingAt(*time) : nullptr;
  if (!landing) return;
  const Theme& theme = plot()->look().theme;
  const QRectF area = chart()->plotArea();
  const QPointF place = plot()->toChart().map(QPointF(landing->cutTime, landing->place));
  painter->setPen(QPen(theme.faintText, 1));
  painter->drawLine(QPointF(place.x(), area.top()), QPointF(place.x(), area.bottom()));
  if (landing->outcome == core::LandingOutcome::kLanded) {
    painter->setPen(QPen(theme.room, 2));
    painter->setBrush(theme.text);
    painter->drawEllipse(place, kDot, kDot);
  }
  const QStringList lines = readings(*landing);
  const QFontMetricsF metrics(plot()->look().font);
  double width = 0;
  for (const QString& line : lines) width = std::max(width, metrics.horizontalAdvance(line));
  QRectF box(place.x() + kGap, m_pointer->y() - kGap, width + 2 * kGap,
             metrics.height() * static_cast<double>(lines.size()) + kGap);
  if (box.right() > area.right()) box.moveRight(place.x() - kGap);
  box.moveBottom(std::min(box.bottom(), area.bottom() - kGap));
  box.moveTop(std::max(box.top(), area.top() + kGap));
  painter->setPen(QPen(theme.faintText, 1));
  painter->setBrush(theme.background);
  painter->drawRoundedRect(box, 4, 4);
  painter->setFont(plot()->look().font);
  painter->setPen(theme.text);
  painter->drawText(box, Qt::AlignCenter, lines.join('\n'));
}

}  // namespace ui
