#include "ui/view/visible_part.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/view/camera.h"
#include "ui/view/drawing.h"

namespace ui {

QRectF paintedArea(const Camera& camera) {
  constexpr double kMargin = 32;  // wider than any stroke's half width
  return QRectF(QPointF(0, 0), camera.viewport()).adjusted(-kMargin, -kMargin, kMargin, kMargin);
}

// Liang and Barsky: the line enters the area at `from` and leaves it at `to`, shares of it.
std::optional<QLineF> lineWithin(const QLineF& line, const QRectF& area) {
  if (!std::isfinite(line.x1() + line.y1() + line.x2() + line.y2())) return {};
  const std::array<double, 4> direction{-line.dx(), line.dx(), -line.dy(), line.dy()};
  const std::array<double, 4> room{line.x1() - area.left(), area.right() - line.x1(),
                                   line.y1() - area.top(), area.bottom() - line.y1()};
  double from = 0;
  double to = 1;
  for (int side = 0; side < 4; ++side) {
    if (direction[side] == 0) {
      if (room[side] < 0) return {};
      continue;
    }
    const double share = room[side] / direction[side];
    if (direction[side] < 0)
      from = std::max(from, share);
    else
      to = std::min(to, share);
  }
  if (from > to) return {};
  return QLineF(line.pointAt(from), line.pointAt(to));
}

std::vector<std::vector<PolylinePoint>> seenStretches(const Polyline& polyline,
                                                      const Camera& camera) {
  const QRectF area = paintedArea(camera);
  std::vector<std::vector<PolylinePoint>> stretches;
  bool goesOn = false;
  const auto shareOf = [&polyline](std::size_t i) {
    return static_cast<double>(i) / static_cast<double>(polyline.points.size() - 1);
  };
  for (std::size_t i = 0; i + 1 < polyline.points.size(); ++i) {
    const QLineF segment(camera.toPixels(polyline.points[i]),
                         camera.toPixels(polyline.points[i + 1]));
    const std::optional<QLineF> seen = lineWithin(segment, area);
    if (!seen) {
      goesOn = false;
      continue;
    }
    if (!goesOn) stretches.push_back({{seen->p1(), shareOf(i)}});
    stretches.back().push_back({seen->p2(), shareOf(i + 1)});
    goesOn = seen->p2() == segment.p2();
  }
  return stretches;
}

std::optional<PixelDisc> seenDisc(const Disc& disc, const Camera& camera) {
  const QPointF center = camera.toPixels(disc.center);
  const double radius = disc.radius * camera.scale() + disc.margin;
  const double reach = radius + 1;
  const bool seen = center.x() > -reach && center.x() < camera.viewport().width() + reach &&
                    center.y() > -reach && center.y() < camera.viewport().height() + reach;
  if (!seen) return {};
  return PixelDisc{center, radius};
}

ArrowShape arrowShape(const Arrow& arrow, const Camera& camera) {
  const QPointF from = camera.toPixels(arrow.from);
  const QPointF tip = camera.toPixels(arrow.to);
  const double length = QLineF(from, tip).length();
  if (length == 0) return {{tip, tip}, {tip, tip, tip}};
  const QPointF along = (tip - from) / length;
  const QPointF across(-along.y(), along.x());
  const QPointF base = tip - std::min(length, kArrowHeadLength * arrow.width) * along;
  const QPointF corner = kArrowHeadWidth * arrow.width / 2 * across;
  return {{from, base}, {tip, base + corner, base - corner}};
}

}  // namespace ui
