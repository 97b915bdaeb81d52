#include "core/trade/stability.h"

#include <cstdint>

#include "core/run/run.h"
#include "core/scene/scene_limits.h"
#include "core/trade/rounded_step.h"

namespace core {
namespace {

/// Weight-steps and events all trials together may take.
constexpr std::int64_t kMostWork = 4'000'000;
constexpr int kBisections = 6;

/// Runs a scene with different steps, until the work is used up.
class Trials {
 public:
  Trials(std::shared_ptr<const Scene> scene, Solver solver, double until)
      : m_scene(std::move(scene)), m_solver(std::move(solver)), m_until(until) {}

  /// False as well where the work does not suffice to find out.
  bool survives(double step) {
    m_solver.step = step;
    Run run(m_scene, m_solver);
    const std::int64_t workPerStep = 1 + run.weightCount();
    if (m_until / step * static_cast<double>(workPerStep) > static_cast<double>(m_left)) {
      m_left = 0;
      return false;
    }
    while (run.time() < m_until) {
      m_left -= workPerStep;
      if (m_left < 0) return false;
      if (run.advance() == RunStatus::kRunning) {
        m_left -= static_cast<std::int64_t>(run.stepEvents().size());
        continue;
      }
      // A step that never ends takes seconds to be given up.
      if (run.status() == RunStatus::kEndless) m_left -= kMostWork / 4;
      return false;
    }
    return true;
  }

  bool hasWorkLeft() const { return m_left > 0; }

 private:
  std::shared_ptr<const Scene> m_scene;
  Solver m_solver;
  double m_until;
  std::int64_t m_left = kMostWork;
};

}  // namespace

std::optional<double> largestStableStep(const std::shared_ptr<const Scene>& scene,
                                        const Solver& solver, double until) {
  Trials trials(scene, solver, until);
  double diverging = solver.step;
  double stable = roundedDown(diverging / 2);
  while (!trials.survives(stable)) {
    diverging = stable;
    stable = roundedDown(diverging / 2);
    if (!trials.hasWorkLeft() || stable < kStepRange.lowest) return std::nullopt;
  }
  for (int i = 0; i < kBisections; ++i) {
    const double middle = roundedDown(0.5 * (stable + diverging));
    if (middle <= stable) break;
    (trials.survives(middle) ? stable : diverging) = middle;
  }
  return stable;
}

}  // namespace core
