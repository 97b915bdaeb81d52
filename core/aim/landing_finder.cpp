#include "core/aim/landing_finder.h"

#include <algorithm>
#include <cmath>

#include "core/aim/landing_history.h"

namespace core {
namespace {

constexpr int kWeightStepsUnasked = 20'000;                 // between two questions
constexpr std::size_t kMostBytes = std::size_t{128} << 20;  // of kept states
constexpr double kTouching = 1e-9;                          // from the floor [m]

Scene uncut(Scene scene) {
  scene.cutTime.reset();
  return scene;
}

/// A weight that slides down from others lands without an impact.
bool liesOnTheFloor(const Scene& scene, const Run& run, int weight) {
  const WeightState state = run.weight(weight);
  const double height = state.position.y() - scene.weights[weight].radius;
  return state.phase == Phase::kResting && height <= kTouching;
}

}  // namespace

LandingFinder::LandingFinder(const Scene& scene, const Solver& solver, int weight,
                             double longestWait)
    : m_scene(uncut(scene)),
      m_solver(solver),
      m_weight(weight),
      m_longestWait(longestWait),
      m_stepsUnasked(
          std::max(1, kWeightStepsUnasked / (1 + static_cast<int>(scene.weights.size())))),
      m_hanging(std::make_shared<const Scene>(m_scene), solver) {
  keep();
}

bool LandingFinder::hangUntil(double time, WorkMeter& meter) {
  for (int step = 1; m_hanging.time() < time; ++step) {
    if (asksNow(step) && !meter.add(0)) return false;
    if (m_hanging.advance() != RunStatus::kRunning) break;
    for (const Event& event : m_hanging.stepEvents()) {
      if (mayMatter(event)) m_events.push_back(event);
    }
    if (m_hanging.stepCount() % m_stride == 0) keep();
  }
  return true;
}

void LandingFinder::keep() {
  m_kept.push_back({m_hanging.state(), m_events.size()});
  m_bytes += m_kept.back().state.bytes();
  if (m_bytes <= kMostBytes || m_kept.size() < 3) return;
  std::vector<Kept> fewer;
  for (std::size_t i = 0; i < m_kept.size(); i += 2) fewer.push_back(std::move(m_kept[i]));
  m_kept = std::move(fewer);
  m_stride *= 2;
  m_bytes = 0;
  for (const Kept& kept : m_kept) m_bytes += kept.state.bytes();
}

/// The last one whose step has its end before the cut or in which the cut falls.
std::size_t LandingFinder::keptBefore(double cutTime) const {
  auto step = static_cast<std::int64_t>(std::floor(cutTime / m_solver.step));
  // A run cuts in the first step that ends at the cut or after it.
  while (step > 0 && static_cast<double>(step) * m_solver.step >= cutTime) --step;
  return std::min(static_cast<std::size_t>(step / m_stride), m_kept.size() - 1);
}

Run LandingFinder::runCutAt(double time) const {
  auto scene = std::make_shared<Scene>(m_scene);
  scene->cutTime = time;
  return {std::move(scene), m_solver};
}

std::optional<Landing> LandingFinder::landing(double cutTime, WorkMeter& meter) const {
  Run run = runCutAt(cutTime);
  LandingHistory history(m_weight);
  if (cutTime > 0) {
    const Kept& kept = m_kept[keptBefore(cutTime)];
    run.restore(kept.state);
    for (std::size_t i = 0; i < kept.eventCount; ++i) history.add(m_events[i]);
  }
  Landing landing{.cutTime = cutTime};
  const auto landed = [&](double place, double time) {
    landing.outcome = LandingOutcome::kLanded;
    landing.place = place;
    landing.time = time;
  };
  for (int step = 1; landing.outcome == LandingOutcome::kNotInTime; ++step) {
    if (run.time() > cutTime + m_longestWait) break;
    if (asksNow(step) && !meter.add(0)) return std::nullopt;
    if (run.advance() != RunStatus::kRunning) {
      landing.outcome = LandingOutcome::kStopped;
      break;
    }
    for (const Event& event : run.stepEvents()) {
      history.add(event);
      if (!history.isLanding(event)) continue;
      landed(event.position.x(), event.time);
      break;
    }
    const bool isOver = landing.outcome == LandingOutcome::kLanded || !history.isCut();
    if (!isOver && liesOnTheFloor(m_scene, run, m_weight))
      landed(run.weight(m_weight).position.x(), run.time());
  }
  landing.firstHit = history.firstHit();
  landing.history = history.mark();
  return landing;
}

}  // namespace core
