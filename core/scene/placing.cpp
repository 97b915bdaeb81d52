#include "core/scene/placing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/scene/overlaps.h"

namespace core {

namespace {

constexpr double kPitchPerRadius = 2.5;     // half a radius of air between two
constexpr std::size_t kMostWork = 2000000;  // discs looked at in all tries
constexpr std::size_t kFewestTries = 8;
constexpr std::size_t kMostTries = 400;
constexpr std::size_t kMostAlone = 100;  // each looked at beside all others

bool isInside(const Room& room, const Eigen::Vector2d& point, double radius) {
  return radius <= point.x() && point.x() <= room.width - radius && radius <= point.y() &&
         point.y() <= room.height - radius;
}

Weight shifted(Weight weight, const Eigen::Vector2d& by) {
  weight.position += by;
  if (weight.rope) weight.rope->pivot += by;
  return weight;
}

/// 0, 1, −1, 2, −2, …
double alternating(int index) {
  return index % 2 == 0 ? -index / 2 : (index + 1) / 2;
}

/// Looks for a shift at which weights and scene are apart.
class Search {
 public:
  Search(const Scene& scene, const std::vector<Weight>& weights)
      : m_room(scene.room), m_weights(weights), m_discs(startDiscs(scene)) {
    m_taken = m_discs.size();
    const std::size_t discs = m_taken + weights.size();
    m_tries = std::clamp(kMostWork / std::max<std::size_t>(discs, 1), kFewestTries, kMostTries);
  }

  bool hasTriesLeft() const { return m_tries > 0; }

  bool fits(const Eigen::Vector2d& by) {
    const bool allInside = std::ranges::all_of(m_weights, [&](const Weight& weight) {
      const Weight moved = shifted(weight, by);
      return isInside(m_room, startPosition(moved), moved.radius) &&
             (!moved.rope || isInside(m_room, moved.rope->pivot, 0));
    });
    if (!allInside) return false;
    --m_tries;
    m_discs.resize(m_taken);
    for (const Weight& weight : m_weights)
      m_discs.push_back({startPosition(weight) + by, weight.radius});
    return std::ranges::none_of(overlapsAmong(m_discs), [this](const Overlap& overlap) {
      const auto latest = static_cast<std::size_t>(std::max(overlap.disc, overlap.other));
      return latest >= m_taken;
    });
  }

 private:
  const Room& m_room;
  const std::vector<Weight>& m_weights;
  std::vector<Disc> m_discs;
  std::size_t m_taken;  // discs of the scene, which stand first
  std::size_t m_tries;
};

/// Shifts all weights by one way, if there is one at which they are apart from the scene.
bool shiftApart(const Scene& scene, std::vector<Weight>& weights) {
  double radius = 0;
  for (const Weight& weight : weights) radius = std::max(radius, weight.radius);
  if (!(radius > 0)) return false;
  const double pitch = kPitchPerRadius * radius;
  const auto placesAlong = [&](double length) {
    return 1 + 2 * static_cast<int>(std::min(length / pitch, double{kMostTries}));
  };
  Search search(scene, weights);
  for (int row = 0; row < placesAlong(scene.room.height); ++row) {
    for (int column = 0; column < placesAlong(scene.room.width); ++column) {
      if (!search.hasTriesLeft()) return false;
      const Eigen::Vector2d by(alternating(column) * pitch, alternating(row) * pitch);
      if (!search.fits(by)) continue;
      for (Weight& weight : weights) weight = shifted(weight, by);
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<Weight> placedApart(const Scene& scene, std::vector<Weight> weights) {
  if (weights.empty() || shiftApart(scene, weights)) return weights;
  if (weights.size() == 1 || weights.size() > kMostAlone) return weights;
  Scene around = scene;
  for (Weight& weight : weights) {
    std::vector<Weight> alone{weight};
    shiftApart(around, alone);
    weight = alone.front();
    around.weights.push_back(weight);
  }
  return weights;
}

Weight firstWeight(const Room& room) {
  Rope rope;
  rope.pivot = {room.width / 2, room.height};
  rope.length = std::min(rope.length, room.height / 2);
  Weight weight;
  weight.rope = rope;
  return weight;
}

}  // namespace core
