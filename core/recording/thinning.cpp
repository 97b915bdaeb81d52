#include "core/recording/thinning.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace core {

namespace {

constexpr std::size_t kMostPerPart = 6;  // first, last, and both extremes of x and y

using Part = std::span<const TimedPoint>;

/// The points of the curve up to this time, beginning with `from`.
Part partUpTo(std::span<const TimedPoint> curve, std::size_t from, double time) {
  const auto rest = curve.subspan(from);
  const auto end = std::ranges::upper_bound(rest, time, {}, &TimedPoint::time);
  return rest.first(static_cast<std::size_t>(end - rest.begin()));
}

void appendExtremes(std::vector<TimedPoint>& kept, Part part) {
  if (part.empty()) return;
  auto [left, right, lowest, highest] =
      std::array{part.begin(), part.begin(), part.begin(), part.begin()};
  for (auto point = part.begin(); point != part.end(); ++point) {
    if (point->x < left->x) left = point;
    if (point->x >= right->x) right = point;
    if (point->y < lowest->y) lowest = point;
    if (point->y >= highest->y) highest = point;
  }
  std::array points{part.begin(), left, right, lowest, highest, part.end() - 1};
  std::ranges::sort(points);
  const auto end = std::unique(points.begin(), points.end());
  for (auto point = points.begin(); point != end; ++point) kept.push_back(**point);
}

}  // namespace

std::vector<TimedPoint> thinned(std::span<const TimedPoint> curve, std::size_t most) {
  assert(most >= 2 * kMostPerPart);
  if (curve.size() <= most) return {curve.begin(), curve.end()};

  const std::size_t parts = most / kMostPerPart;
  const double width = (curve.back().time - curve.front().time) / static_cast<double>(parts);
  std::vector<TimedPoint> kept;
  kept.reserve(parts * kMostPerPart);
  std::size_t done = 0;
  for (std::size_t i = 1; i < parts; ++i) {
    const Part part = partUpTo(curve, done, curve.front().time + width * static_cast<double>(i));
    appendExtremes(kept, part);
    done += part.size();
  }
  appendExtremes(kept, curve.subspan(done));
  return kept;
}

}  // namespace core
