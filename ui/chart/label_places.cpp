#include "ui/chart/label_places.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {
namespace {

constexpr int kProbes = 12;       // along each piece of a curve
constexpr double kOutside = 1e3;  // as bad as so many covered probes
constexpr double kOnLabel = 100;

/// Points so close that no label fits between them.
std::vector<QPointF> probesOf(const std::vector<LabelledCurve>& curves) {
  std::vector<QPointF> probes;
  for (const LabelledCurve& curve : curves) {
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      const QPointF way = curve.points[i] - curve.points[i - 1];
      for (int k = 0; k < kProbes; ++k) probes.push_back(curve.points[i - 1] + way * k / kProbes);
    }
    probes.insert(probes.end(), curve.points.begin(), curve.points.end());
  }
  return probes;
}

/// Right, left, at the corners, below and above.
std::array<QRectF, 8> placesBeside(const QPointF& point, const QSizeF& size, double gap) {
  const double w = size.width(), h = size.height();
  const auto at = [&](double dx, double dy) { return QRectF(point + QPointF(dx, dy), size); };
  return {at(gap, -h / 2),   at(-gap - w, -h / 2),   at(gap, -h - gap), at(gap, gap),
          at(-gap - w, gap), at(-gap - w, -h - gap), at(-w / 2, gap),   at(-w / 2, -gap - h)};
}

double badness(const QRectF& place, double gap, const QRectF& area,
               const std::vector<QPointF>& probes, const std::vector<QRectF>& taken) {
  double sum = area.contains(place) ? 0 : kOutside;
  const QRectF kept = place.adjusted(-gap / 2, -gap / 2, gap / 2, gap / 2);
  for (const QPointF& probe : probes) sum += kept.contains(probe) ? 1 : 0;
  for (const QRectF& other : taken) sum += place.intersects(other) ? kOnLabel : 0;
  return sum;
}

}  // namespace

std::vector<QRectF> labelPlaces(const std::vector<LabelledCurve>& curves, const QRectF& area,
                                double gap) {
  const std::vector<QPointF> probes = probesOf(curves);
  std::vector<QRectF> places;
  for (const LabelledCurve& curve : curves) {
    QRectF best;
    double least = INFINITY;
    for (auto point = curve.points.rbegin(); point != curve.points.rend(); ++point) {
      for (const QRectF& place : placesBeside(*point, curve.label, gap)) {
        const double bad = badness(place, gap, area, probes, places);
        if (bad >= least) continue;
        best = place;
        least = bad;
      }
    }
    places.push_back(best);
  }
  return places;
}

}  // namespace ui
