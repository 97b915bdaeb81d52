#include "core/recording/thinning.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace core {

namespace {

constexpr std::size_t kMostPerPart = 4;  // first, lowest, highest, last

using Part = std::span<const CurvePoint>;

/// The points of the curve up to x, beginning with `from`.
Part partUpTo(std::span<const CurvePoint> curve, std::size_t from, double x) {
  const auto rest = curve.subspan(from);
  const auto end = std::ranges::upper_bound(rest, x, {}, &CurvePoint::x);
  return rest.first(static_cast<std::size_t>(end - rest.begin()));
}

void appendExtremes(std::vector<CurvePoint>& kept, Part part) {
  if (part.empty()) return;
  const auto [lowest, highest] = std::ranges::minmax_element(part, {}, &CurvePoint::y);
  std::array points{part.begin(), lowest, highest, part.end() - 1};
  std::ranges::sort(points);
  const auto end = std::unique(points.begin(), points.end());
  for (auto point = points.begin(); point != end; ++point) kept.push_back(**point);
}

}  // namespace

std::vector<CurvePoint> thinned(std::span<const CurvePoint> curve, std::size_t most) {
  assert(most >= 2 * kMostPerPart);
  if (curve.size() <= most) return {curve.begin(), curve.end()};

  const std::size_t parts = most / kMostPerPart;
  const double width = (curve.back().x - curve.front().x) / static_cast<double>(parts);
  std::vector<CurvePoint> kept;
  kept.reserve(parts * kMostPerPart);
  std::size_t done = 0;
  for (std::size_t i = 1; i < parts; ++i) {
    const Part part = partUpTo(curve, done, curve.front().x + width * static_cast<double>(i));
    appendExtremes(kept, part);
    done += part.size();
  }
  appendExtremes(kept, curve.subspan(done));
  return kept;
}

}  // namespace core
