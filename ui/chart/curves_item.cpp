#include "ui/chart/curves_item.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <QChart>
#include <QPainter>

namespace ui {

namespace {

constexpr double kHatchSpacing = 9;  // [px] along the horizontal
constexpr double kHatchWidth = 1.5;  // [px]
constexpr double kUnseen = 0.2;      // a bend so small is not seen [px]

/// Of a point from the line between two others.
double distance(QPointF point, QPointF from, QPointF to) {
  const QPointF way = to - from;
  const double length = std::hypot(way.x(), way.y());
  const QPointF off = point - from;
  if (length == 0) return std::hypot(off.x(), off.y());
  const double along = QPointF::dotProduct(off, way) / length;
  if (along < 0) return std::hypot(off.x(), off.y());
  if (along > length) return std::hypot(point.x() - to.x(), point.y() - to.y());
  return std::abs(off.x() * way.y() - off.y() * way.x()) / length;
}

void paintHatch(QPainter& painter, const DrawnCurve& curve, const QTransform& toPlot) {
  painter.setPen(QPen(curve.pen.color(), kHatchWidth));
  const int direction = curve.run % 2 == 0 ? 1 : -1;
  for (const QPolygonF& area : curve.areas) {
    for (const QLineF& line : hatchLines(toPlot.map(area), kHatchSpacing, direction)) {
      painter.drawLine(line);
    }
  }
}

}  // namespace

CurvesItem::CurvesItem(QChart* chart) : QGraphicsItem(chart), m_chart(chart) {
  constexpr double kAboveGrid = 10;
  setZValue(kAboveGrid);
}

void CurvesItem::setCurves(std::vector<DrawnCurve> curves, const QRectF& range) {
  m_curves = std::move(curves);
  m_range = range;
  update();
}

QRectF CurvesItem::boundingRect() const {
  return QRectF(QPointF(0, 0), m_chart->size());
}

void CurvesItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const QTransform toPlot = plotTransform(m_range, m_chart->plotArea());
  for (auto curve = m_curves.rbegin(); curve != m_curves.rend(); ++curve) {
    if (curve->fill.style() == Qt::NoBrush) continue;
    painter->setPen(Qt::NoPen);
    painter->setBrush(curve->fill);
    for (const QPolygonF& area : curve->areas) painter->drawPolygon(toPlot.map(area));
  }
  for (const DrawnCurve& curve : m_curves) {
    if (curve.hatched) paintHatch(*painter, curve, toPlot);
  }
  painter->setBrush(Qt::NoBrush);
  const bool smooth = painter->testRenderHint(QPainter::Antialiasing);
  for (const DrawnCurve& curve : m_curves) {
    if (curve.pen.style() == Qt::NoPen) continue;
    painter->setPen(curve.pen);
    painter->setRenderHint(QPainter::Antialiasing, smooth && !curve.dense);
    for (const QPolygonF& line : curve.lines) {
      const QPolygonF places = toPlot.map(line);
      painter->drawPolyline(curve.dense ? places : simplified(places, kUnseen));
    }
  }
  painter->setRenderHint(QPainter::Antialiasing, smooth);
}

QTransform plotTransform(const QRectF& range, const QRectF& plot) {
  const double scaleX = plot.width() / range.width();
  const double scaleY = -plot.height() / range.height();
  return QTransform(scaleX, 0, 0, scaleY, plot.left() - range.left() * scaleX,
                    plot.bottom() - range.top() * scaleY);
}

QPolygonF simplified(const QPolygonF& line, double tolerance) {
  if (line.size() < 3) return line;
  std::vector<bool> kept(line.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<qsizetype, qsizetype>> stretches = {{0, line.size() - 1}};
  while (!stretches.empty()) {
    const auto [first, last] = stretches.back();
    stretches.pop_back();
    qsizetype furthest = first;
    double most = tolerance;
    for (qsizetype i = first + 1; i < last; ++i) {
      const double off = distance(line[i], line[first], line[last]);
      if (off <= most) continue;
      most = off;
      furthest = i;
    }
    if (furthest == first) continue;
    kept[furthest] = true;
    stretches.emplace_back(first, furthest);
    stretches.emplace_back(furthest, last);
  }
  QPolygonF fewer;
  for (qsizetype i = 0; i < line.size(); ++i) {
    if (kept[i]) fewer.append(line[i]);
  }
  return fewer;
}

std::vector<QLineF> hatchLines(const QPolygonF& area, double spacing, int direction) {
  // Line number n holds the points with x + direction · y = n · spacing; where it crosses the
  // polygon's edges it enters and leaves in turn.
  const auto number = [&](QPointF point) { return (point.x() + direction * point.y()) / spacing; };
  std::map<int, std::vector<QPointF>> crossings;
  for (qsizetype i = 0; i < area.size(); ++i) {
    const QPointF from = area[i];
    const QPointF to = area[i + 1 < area.size() ? i + 1 : 0];
    const double least = std::min(number(from), number(to));
    const double most = std::max(number(from), number(to));
    for (int n = static_cast<int>(std::floor(least)) + 1; n <= most; ++n) {
      const double part = (n - number(from)) / (number(to) - number(from));
      crossings[n].push_back(from + part * (to - from));
    }
  }
  std::vector<QLineF> lines;
  for (auto& [n, points] : crossings) {
    std::ranges::sort(points, {}, &QPointF::x);
    for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
      lines.emplace_back(points[i], points[i + 1]);
    }
  }
  return lines;
}

}  // namespace ui
