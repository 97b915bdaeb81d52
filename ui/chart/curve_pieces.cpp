#include "ui/chart/curve_pieces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <QLineF>

namespace ui {

namespace {

using core::TimedPoint;
using Curve = std::span<const TimedPoint>;

constexpr std::size_t kFewestPoints = 12;

bool isFinite(const TimedPoint& point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

/// The point, or one in its direction not so far away that differences overflow.
QPointF near(const TimedPoint& point, const QRectF& range) {
  constexpr double kFar = 1e9;  // in sizes of the range
  const auto bounded = [](double value, double middle, double size) {
    return std::clamp(value, middle - kFar * size, middle + kFar * size);
  };
  return {bounded(point.x, range.center().x(), range.width()),
          bounded(point.y, range.center().y(), range.height())};
}

/// Calls `use` with each stretch between gaps, thinned.
void forEachStretch(Curve curve, std::size_t most,
                    const std::function<void(const std::vector<TimedPoint>&)>& use) {
  auto begin = curve.begin();
  while (true) {
    begin = std::find_if(begin, curve.end(), isFinite);
    if (begin == curve.end()) return;
    const auto end = std::find_if_not(begin, curve.end(), isFinite);
    const auto count = static_cast<std::size_t>(end - begin);
    const std::size_t share = most * count / curve.size();
    use(core::thinned(Curve(begin, end), std::max(share, kFewestPoints)));
    begin = end;
  }
}

/// What of a line lies in a rectangle (Liang and Barsky).
std::optional<QLineF> lineInside(QPointF from, QPointF to, const QRectF& range) {
  double first = 0;
  double last = 1;
  const auto cut = [&](double way, double room) {
    // way · t ≤ room
    if (way == 0) return room >= 0;
    const double t = room / way;
    if (way > 0) last = std::min(last, t);
    if (way < 0) first = std::max(first, t);
    return first <= last;
  };
  const QPointF way = to - from;
  const bool isInside =
      cut(-way.x(), from.x() - range.left()) && cut(way.x(), range.right() - from.x()) &&
      cut(-way.y(), from.y() - range.top()) && cut(way.y(), range.bottom() - from.y());
  if (!isInside) return std::nullopt;
  const QPointF start = first > 0 ? from + first * way : from;
  return QLineF(start, last < 1 ? from + last * way : to);
}

void appendPieces(std::vector<QPolygonF>& pieces, const std::vector<TimedPoint>& stretch,
                  const QRectF& range) {
  QPolygonF piece;
  const auto finish = [&] {
    if (!piece.isEmpty()) pieces.push_back(piece);
    piece.clear();
  };
  QPointF from = near(stretch.front(), range);
  if (stretch.size() == 1 && lineInside(from, from, range)) piece.append(from);
  for (std::size_t i = 1; i < stretch.size(); ++i) {
    const QPointF to = near(stretch[i], range);
    if (const auto line = lineInside(from, to, range)) {
      if (piece.isEmpty()) piece.append(line->p1());
      piece.append(line->p2());
      if (line->p2() != to) finish();
    } else {
      finish();
    }
    from = to;
  }
  finish();
}

/// The part of a polygon on one side of a line (Sutherland and Hodgman).
/// @param depth  how far inside a point lies; negative outside; linear
QPolygonF cutOff(const QPolygonF& polygon, const std::function<double(QPointF)>& depth) {
  QPolygonF cut;
  cut.reserve(polygon.size() + 4);
  for (qsizetype i = 0; i < polygon.size(); ++i) {
    const QPointF from = polygon[i == 0 ? polygon.size() - 1 : i - 1];
    const QPointF to = polygon[i];
    const double before = depth(from);
    const double after = depth(to);
    if ((before < 0) != (after < 0)) cut.append(from + before / (before - after) * (to - from));
    if (after >= 0) cut.append(to);
  }
  return cut;
}

QPolygonF areaInside(QPolygonF area, const QRectF& range) {
  area = cutOff(area, [&](QPointF point) { return point.x() - range.left(); });
  area = cutOff(area, [&](QPointF point) { return range.right() - point.x(); });
  area = cutOff(area, [&](QPointF point) { return point.y() - range.top(); });
  return cutOff(area, [&](QPointF point) { return range.bottom() - point.y(); });
}

}  // namespace

std::vector<QPolygonF> piecesInside(Curve curve, const QRectF& range, std::size_t most) {
  std::vector<QPolygonF> pieces;
  forEachStretch(curve, most, [&](const std::vector<TimedPoint>& stretch) {
    appendPieces(pieces, stretch, range);
  });
  return pieces;
}

std::vector<QPolygonF> areasInside(Curve curve, double base, const QRectF& range,
                                   std::size_t most) {
  std::vector<QPolygonF> areas;
  forEachStretch(curve, most, [&](const std::vector<TimedPoint>& stretch) {
    QPolygonF area;
    for (const TimedPoint& point : stretch) area.append(near(point, range));
    const QPointF end = near({0, stretch.back().x, base}, range);
    area << end << QPointF(area.first().x(), end.y());
    area = areaInside(area, range);
    if (!area.isEmpty()) areas.push_back(area);
  });
  return areas;
}

Curve partBetween(Curve curve, double from, double to) {
  auto begin = std::ranges::lower_bound(curve, from, {}, &TimedPoint::time);
  auto end = std::ranges::upper_bound(curve, to, {}, &TimedPoint::time);
  if (begin != curve.begin()) --begin;
  if (end != curve.end()) ++end;
  return begin < end ? Curve(begin, end) : Curve();
}

std::size_t mostPointsPerCurve(std::size_t curves, std::size_t mostForAll) {
  return std::min(kMostPointsOfACurve, mostForAll / std::max<std::size_t>(curves, 1));
}

}  // namespace ui
