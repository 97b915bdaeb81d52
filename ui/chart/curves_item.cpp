#include "ui/chart/curves_item.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>
#include <utility>

#include <QChart>
#include <QPainter>

namespace ui {

namespace {

constexpr double kHatchSpacing = 9;  // [px] along the horizontal
constexpr double kHatchWidth = 1.5;  // [px]

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
  for (const DrawnCurve& curve : m_curves | std::views::reverse) {
    if (curve.fill.style() == Qt::NoBrush) continue;
    painter->setPen(Qt::NoPen);
    painter->setBrush(curve.fill);
    for (const QPolygonF& area : curve.areas) painter->drawPolygon(toPlot.map(area));
  }
  for (const DrawnCurve& curve : m_curves) {
    if (curve.hatched) paintHatch(*painter, curve, toPlot);
  }
  painter->setBrush(Qt::NoBrush);
  for (const DrawnCurve& curve : m_curves) {
    if (curve.pen.style() == Qt::NoPen) continue;
    painter->setPen(curve.pen);
    for (const QPolygonF& line : curve.lines) painter->drawPolyline(toPlot.map(line));
  }
}

QTransform plotTransform(const QRectF& range, const QRectF& plot) {
  const double scaleX = plot.width() / range.width();
  const double scaleY = -plot.height() / range.height();
  return QTransform(scaleX, 0, 0, scaleY, plot.left() - range.left() * scaleX,
                    plot.bottom() - range.top() * scaleY);
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
