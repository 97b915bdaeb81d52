#include "ui/chart/curve_points.h"

#include <algorithm>

namespace ui {

namespace {

using core::CurvePoint;

bool isInside(const CurvePoint& point, double lowest, double highest) {
  return lowest <= point.y && point.y <= highest;
}

QPointF crossing(const CurvePoint& from, const CurvePoint& to, double limit) {
  // Halves first: the difference of two opposite huge values would be infinite.
  const double part = (limit / 2 - from.y / 2) / (to.y / 2 - from.y / 2);
  return {from.x + part * (to.x - from.x), limit};
}

/// Appends where the way from one point to the next crosses a limit, in order of x.
void appendCrossings(QList<QPointF>& cut, const CurvePoint& from, const CurvePoint& to,
                     double lowest, double highest) {
  const bool crossesLowest = (from.y < lowest) != (to.y < lowest);
  const bool crossesHighest = (from.y > highest) != (to.y > highest);
  const bool rising = from.y < to.y;
  if (crossesLowest && rising) cut.append(crossing(from, to, lowest));
  if (crossesHighest) cut.append(crossing(from, to, highest));
  if (crossesLowest && !rising) cut.append(crossing(from, to, lowest));
}

}  // namespace

QList<QPointF> cutToScale(const std::vector<CurvePoint>& curve, double lowest, double highest) {
  const auto inside = [&](const CurvePoint& point) { return isInside(point, lowest, highest); };
  auto first = std::find_if(curve.begin(), curve.end(), inside);
  if (first == curve.end()) return {};
  auto last = std::find_if(curve.rbegin(), curve.rend(), inside).base();  // one behind
  if (first != curve.begin()) --first;
  if (last != curve.end()) ++last;

  QList<QPointF> cut;
  cut.reserve(last - first);
  for (auto point = first; point != last; ++point) {
    if (point != first) appendCrossings(cut, *(point - 1), *point, lowest, highest);
    if (inside(*point)) cut.append({point->x, point->y});
  }
  return cut;
}

std::size_t mostPointsPerCurve(std::size_t curves, std::size_t mostForAll) {
  return std::min(kMostPointsOfACurve, mostForAll / std::max<std::size_t>(curves, 1));
}

}  // namespace ui
