#include "core/scene/free_places.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/scene/overlaps.h"
#include "core/scene/scene_limits.h"

namespace core {

namespace {

/// Evenly spaced coordinates of centers between two walls, one of them the model's.
struct Axis {
  double first;
  double pitch;
  std::int64_t count;
  std::int64_t ofModel;

  Axis(double model, double radius, double size)
      : pitch(2.5 * radius),  // half a radius of air between two
        ofModel(placesWithin(model - radius)) {
    first = model - pitch * static_cast<double>(ofModel);
    count = ofModel + 1 + placesWithin(size - radius - model);
  }

  double at(std::int64_t index) const { return first + pitch * static_cast<double>(index); }

 private:
  std::int64_t placesWithin(double distance) const {
    return std::max(std::int64_t{0}, static_cast<std::int64_t>(distance / pitch));
  }
};

/// Rows of places through the whole room, counted from the model on.
class Lattice {
 public:
  Lattice(const Room& room, const Weight& model)
      : m_across(model.position.x(), model.radius, room.width),
        m_upwards(model.position.y(), model.radius, room.height) {}

  /// Places besides the model's own.
  std::size_t count() const {
    return static_cast<std::size_t>(m_across.count * m_upwards.count - 1);
  }

  /// @param index  from 0 to count() − 1
  Eigen::Vector2d place(std::size_t index) const {
    const std::int64_t model = m_upwards.ofModel * m_across.count + m_across.ofModel;
    const std::int64_t cell =
        (model + 1 + static_cast<std::int64_t>(index)) % (m_across.count * m_upwards.count);
    return {m_across.at(cell % m_across.count), m_upwards.at(cell / m_across.count)};
  }

 private:
  Axis m_across;
  Axis m_upwards;
};

bool canStandAlone(const Room& room, const Weight& model) {
  Scene alone;
  alone.room = room;
  alone.weights.push_back(model);
  return problemsIn(alone).empty();
}

/// Those of the first `tried` places of the lattice where nothing stands.
std::vector<Eigen::Vector2d> unoccupied(const Lattice& lattice, std::size_t tried,
                                        std::vector<Disc> discs, double radius) {
  const std::size_t taken = discs.size();
  for (std::size_t i = 0; i < tried; ++i) discs.push_back({lattice.place(i), radius});
  std::vector<bool> isFree(discs.size(), true);
  for (const Overlap& overlap : overlapsAmong(discs)) {
    isFree[static_cast<std::size_t>(overlap.disc)] = false;
    isFree[static_cast<std::size_t>(overlap.other)] = false;
  }
  std::vector<Eigen::Vector2d> places;
  for (std::size_t i = taken; i < discs.size(); ++i) {
    if (isFree[i]) places.push_back(discs[i].center);
  }
  return places;
}

}  // namespace

std::vector<Eigen::Vector2d> freePlaces(const Scene& scene, const Weight& model,
                                        std::size_t wanted) {
  constexpr std::size_t kMostTried = 4 * std::size_t{kMostWeights};
  if (wanted == 0 || !canStandAlone(scene.room, model)) return {};
  const Lattice lattice(scene.room, model);
  const std::vector<Disc> discs = startDiscs(scene);
  const std::size_t most = std::min(lattice.count(), kMostTried);
  std::vector<Eigen::Vector2d> places;
  std::size_t tried = 0;
  while (places.size() < wanted && tried < most) {
    tried = std::min(most, std::max(2 * tried, wanted + discs.size()));
    places = unoccupied(lattice, tried, discs, model.radius);
  }
  places.resize(std::min(places.size(), wanted));
  return places;
}

}  // namespace core
