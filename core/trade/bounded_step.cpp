#include "core/trade/bounded_step.h"

#include <algorithm>
#include <cmath>

#include "core/scene/scene_limits.h"
#include "core/trade/boundedness.h"
#include "core/trade/rounded_step.h"
#include "core/trade/settings.h"

namespace core {
namespace {

constexpr double kFirstTried = 1.0 / 1024;  // [s]
constexpr double kSmallestTried = 1.0 / 65536;
constexpr int kBisections = 8;

/// The search for one method.
class Search {
 public:
  Search(const std::shared_ptr<const Scene>& scene, const Method& method, double until,
         WorkMeter& meter)
      : m_scene(scene), m_method(method), m_until(until), m_meter(meter) {}

  BoundedStep result() {
    BoundedStep found{&m_method, std::nullopt, false};
    double bounded = kFirstTried;
    while (!staysBounded(bounded)) {
      bounded /= 2;
      if (bounded < kSmallestTried || m_stopped) return found;
    }
    const double largest = std::min(m_until, kStepRange.highest);
    double tooLarge = 2 * bounded;
    while (tooLarge < largest && staysBounded(tooLarge)) {
      bounded = tooLarge;
      tooLarge *= 2;
    }
    if (tooLarge >= largest && staysBounded(largest)) return {&m_method, largest, true};
    found.step = bisected(bounded, std::min(tooLarge, largest));
    return found;
  }

 private:
  double bisected(double bounded, double tooLarge) {
    double found = roundedDown(bounded);
    for (int i = 0; i < kBisections && !m_stopped; ++i) {
      const double middle = roundedDown(0.5 * (found + tooLarge));
      if (middle <= found) break;
      (staysBounded(middle) ? found : tooLarge) = middle;
    }
    return found;
  }

  bool staysBounded(double step) {
    const auto trial = boundednessOf(m_scene, solverWith(m_method, step), m_until, m_meter);
    m_stopped = !trial;
    return trial && trial->outcome == Boundedness::kBounded;
  }

  const std::shared_ptr<const Scene>& m_scene;
  const Method& m_method;
  double m_until;
  WorkMeter& m_meter;
  bool m_stopped = false;
};

}  // namespace

std::optional<std::vector<BoundedStep>> largestBoundedSteps(
    const std::shared_ptr<const Scene>& scene, double until, const Progress& progress) {
  std::vector<const Method*> stepping;
  for (const Method& method : methods()) {
    if (!method.isAdaptive) stepping.push_back(&method);
  }
  WorkMeter meter(static_cast<double>(stepping.size()), progress);
  std::vector<BoundedStep> steps;
  for (const Method* method : stepping) {
    steps.push_back(Search(scene, *method, until, meter).result());
    if (!meter.add(1)) return std::nullopt;
  }
  return steps;
}

}  // namespace core
