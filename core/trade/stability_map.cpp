#include "core/trade/stability_map.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <thread>

#include "core/scene/scene_limits.h"
#include "core/trade/settings.h"

namespace core {
namespace {

/// 2^(first/perDoubling), … 2^(last/perDoubling).
std::vector<double> powersOfTwo(int first, int last, int perDoubling) {
  std::vector<double> powers;
  for (int i = first; i <= last; ++i) powers.push_back(std::exp2(double(i) / perDoubling));
  return powers;
}

double longestRope(const Scene& scene) {
  double longest = 0;
  for (const Weight& weight : scene.weights) {
    if (weight.rope) longest = std::max(longest, weight.rope->length);
  }
  return longest;
}

std::vector<double> mappedValues(const Scene& scene, MapQuantity quantity) {
  if (quantity == MapQuantity::kRopeLength) {
    std::vector<double> lengths = powersOfTwo(-12, 4, 2);
    for (double& length : lengths) length *= longestRope(scene);
    return lengths;
  }
  std::vector<double> densities = powersOfTwo(0, 14, 1);
  for (double& density : densities) density *= 0.1;
  densities.push_back(kAirDensityRange.highest);
  return densities;
}

/// All cells of one map, by several threads.
class MapWork {
 public:
  MapWork(const Scene& scene, StabilityMap& map, const Progress& progress)
      : m_map(map), m_meter(static_cast<double>(map.cells.size()), progress) {
    for (const double value : map.values) {
      Scene changed = withQuantity(scene, map.quantity, value);
      const bool canRun = problemsIn(changed).empty();
      m_scenes.push_back(canRun ? std::make_shared<const Scene>(std::move(changed)) : nullptr);
    }
  }

  /// @return  false if it was stopped
  bool tryAll() {
    {
      const std::jthread helper([this] { tryRemaining(); });
      tryRemaining();
    }
    return m_meter.add(0);
  }

 private:
  void tryRemaining() {
    for (std::size_t i = m_next++; i < m_map.cells.size(); i = m_next++) {
      const std::shared_ptr<const Scene>& scene = m_scenes[i / m_map.steps.size()];
      if (scene) {
        const Solver solver = solverWith(*m_map.method, m_map.steps[i % m_map.steps.size()]);
        m_map.cells[i] = boundednessOf(scene, solver, m_map.until, m_meter);
      }
      if (!m_meter.add(1)) return;
    }
  }

  StabilityMap& m_map;
  std::vector<std::shared_ptr<const Scene>> m_scenes;  // one for each value; may be null
  WorkMeter m_meter;
  std::atomic<std::size_t> m_next = 0;
};

}  // namespace

bool canBeMapped(const Scene& scene, MapQuantity quantity) {
  return quantity == MapQuantity::kAirDensity || longestRope(scene) > 0;
}

Scene withQuantity(Scene scene, MapQuantity quantity, double value) {
  assert(canBeMapped(scene, quantity));
  if (quantity == MapQuantity::kAirDensity) {
    scene.airDensity = value;
    return scene;
  }
  const double factor = value / longestRope(scene);
  for (Weight& weight : scene.weights) {
    if (weight.rope) weight.rope->length *= factor;
  }
  return scene;
}

std::optional<StabilityMap> stabilityMap(const Scene& scene, const Method& method,
                                         MapQuantity quantity, double until,
                                         const Progress& progress) {
  assert(!method.isAdaptive);
  StabilityMap map{&method, quantity, until, powersOfTwo(-20, 0, 2), mappedValues(scene, quantity),
                   {}};
  map.cells.resize(map.steps.size() * map.values.size());
  if (!MapWork(scene, map, progress).tryAll()) return std::nullopt;
  return map;
}

}  // namespace core
