#include "ui/style/event_mark.h"

#include <cmath>

#include <QPainter>
#include <QPainterPath>

#include "ui/style/theme.h"

namespace ui {
namespace {

/// A sign in a square from −1 to 1, y down.
struct Sign {
  QPainterPath path;
  QColor color;
  bool isFilled = true;
};

QPainterPath polygon(std::initializer_list<QPointF> points) {
  QPainterPath path;
  path.addPolygon(QPolygonF(QList<QPointF>(points)));
  path.closeSubpath();
  return path;
}

/// A triangle whose tip points so many quarter turns clockwise from down.
QPainterPath triangle(int quarterTurns) {
  QTransform turn;
  turn.rotate(90.0 * quarterTurns);
  return turn.map(polygon({{-1, -0.8}, {1, -0.8}, {0, 0.9}}));
}

QPainterPath square() {
  return polygon({{-0.75, -0.75}, {0.75, -0.75}, {0.75, 0.75}, {-0.75, 0.75}});
}

QPainterPath cross() {
  constexpr double kArm = 0.85, kWidth = 0.3;
  QPainterPath bar;
  bar.addRect(-kArm * std::sqrt(2.0), -kWidth, 2 * kArm * std::sqrt(2.0), 2 * kWidth);
  QTransform up, down;
  up.rotate(-45);
  down.rotate(45);
  return up.map(bar).united(down.map(bar));
}

QPainterPath circle() {
  QPainterPath path;
  path.addEllipse(QPointF(0, 0), 0.8, 0.8);
  return path;
}

Sign signOf(core::EventKind kind, const Theme& theme) {
  switch (kind) {
    case core::EventKind::kCut:
      return {cross(), theme.drift};
    case core::EventKind::kTurningPoint:
      return {circle(), theme.potential, false};
    case core::EventKind::kSlack:
      return {square(), theme.lostToRopes, false};
    case core::EventKind::kTaut:
      return {square(), theme.lostToRopes};
    case core::EventKind::kImpactFloor:
      return {triangle(0), theme.lostToImpacts};
    case core::EventKind::kImpactWest:
      return {triangle(1), theme.lostToImpacts};
    case core::EventKind::kImpactCeiling:
      return {triangle(2), theme.lostToImpacts};
    case core::EventKind::kImpactEast:
      return {triangle(3), theme.lostToImpacts};
    case core::EventKind::kImpactWeight:
      return {polygon({{0, -1}, {1, 0}, {0, 1}, {-1, 0}}), theme.kinetic};
    case core::EventKind::kRest:
      return {polygon({{-1, -0.35}, {1, -0.35}, {1, 0.35}, {-1, 0.35}}), theme.lostToFriction};
  }
  return {};
}

}  // namespace

void drawEventMark(QPainter& painter, core::EventKind kind, QPointF centre, double size,
                   const Theme& theme) {
  constexpr double kLine = 0.22;  // of the size
  constexpr double kHalo = 1;     // px around, so that signs that overlap stay apart
  const Sign sign = signOf(kind, theme);
  QTransform place;
  place.translate(centre.x(), centre.y());
  const double radius = size / 2 - (sign.isFilled ? 0 : kLine * size / 2);
  place.scale(radius, radius);
  const QPainterPath path = place.map(sign.path);
  painter.save();
  const double line = sign.isFilled ? 0 : kLine * size;
  painter.strokePath(path, QPen(theme.background, line + 2 * kHalo));
  painter.fillPath(path, sign.isFilled ? sign.color : theme.background);
  if (!sign.isFilled) painter.strokePath(path, QPen(sign.color, line));
  painter.restore();
}

}  // namespace ui
