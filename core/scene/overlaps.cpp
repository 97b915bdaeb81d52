#include "core/scene/overlaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/scene/scene_limits.h"

namespace core {

namespace {

bool overlap(const Disc& a, const Disc& b) {
  const double touching = (a.radius + b.radius) * (1 - kTouchTolerance);
  return (a.center - b.center).squaredNorm() < touching * touching;
}

bool takesPart(const Disc& disc) {
  constexpr double kFarthest = kRoomSizeRange.highest;
  return kRadiusRange.contains(disc.radius) && std::abs(disc.center.x()) <= kFarthest &&
         std::abs(disc.center.y()) <= kFarthest;
}

/// Size class of a disc: radii of a class lie in [2^(size − 1), 2^size).
int sizeOf(const Disc& disc) {
  int size = 0;
  std::frexp(disc.radius, &size);
  return size;
}

/// Square grid for the discs of one size class.
class SizeGrid {
 public:
  explicit SizeGrid(int size) : m_largest(std::ldexp(1.0, size)) {}

  /// A disc of the grid that `disc` overlaps.
  std::optional<int> overlapped(std::span<const Disc> discs, const Disc& disc) const {
    const double reach = disc.radius + m_largest;
    for (auto i = cellAt(disc.center.x() - reach); i <= cellAt(disc.center.x() + reach); ++i) {
      for (auto j = cellAt(disc.center.y() - reach); j <= cellAt(disc.center.y() + reach); ++j) {
        const auto cell = m_cells.find(key(i, j));
        if (cell == m_cells.end()) continue;
        for (const int other : cell->second) {
          if (overlap(disc, discs[other])) return other;
        }
      }
    }
    return std::nullopt;
  }

  void add(std::span<const Disc> discs, int index, bool overlapsAnother) {
    const Disc& disc = discs[index];
    auto& cell = m_cells[key(cellAt(disc.center.x()), cellAt(disc.center.y()))];
    // Discs apart from each other are few in a cell; only a heap could fill it.
    if (!overlapsAnother || cell.size() < kMostOfAHeap) cell.push_back(index);
  }

 private:
  static constexpr std::size_t kMostOfAHeap = 32;

  // No smaller disc than those of the grid reaches over more than two cells each way.
  std::int64_t cellAt(double x) const {
    return static_cast<std::int64_t>(std::floor(x / (4 * m_largest)));
  }

  // The smallest cells of the largest room have numbers below 2^31.
  static std::uint64_t key(std::int64_t i, std::int64_t j) {
    return (static_cast<std::uint64_t>(i) << 32) ^ (static_cast<std::uint64_t>(j) & 0xffffffffU);
  }

  double m_largest;  // upper bound of the radii [m]
  std::unordered_map<std::uint64_t, std::vector<int>> m_cells;
};

/// Indices of the discs that take part, large size classes first.
std::vector<int> largeFirst(std::span<const Disc> discs) {
  std::vector<int> order;
  order.reserve(discs.size());
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (takesPart(discs[i])) order.push_back(static_cast<int>(i));
  }
  std::ranges::stable_sort(order, std::greater(), [&](int i) { return sizeOf(discs[i]); });
  return order;
}

}  // namespace

std::vector<Overlap> overlapsAmong(std::span<const Disc> discs) {
  std::vector<Overlap> overlaps;
  std::vector<std::pair<int, SizeGrid>> grids;  // large size classes first
  for (const int index : largeFirst(discs)) {
    const int size = sizeOf(discs[index]);
    if (grids.empty() || grids.back().first != size) grids.emplace_back(size, SizeGrid(size));
    std::optional<int> other;
    for (auto grid = grids.rbegin(); grid != grids.rend() && !other; ++grid) {
      other = grid->second.overlapped(discs, discs[index]);
    }
    if (other) overlaps.push_back({index, *other});
    grids.back().second.add(discs, index, other.has_value());
  }
  std::ranges::sort(overlaps, {}, &Overlap::disc);
  return overlaps;
}

std::vector<Disc> startDiscs(const Scene& scene) {
  std::vector<Disc> discs;
  discs.reserve(scene.weights.size());
  for (const Weight& weight : scene.weights) {
    discs.push_back({startPosition(weight), weight.radius});
  }
  return discs;
}

}  // namespace core
