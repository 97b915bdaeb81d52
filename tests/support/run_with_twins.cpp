#include "tests/support/run_with_twins.h"

#include <algorithm>
#include <memory>
#include <random>

#include "core/scene/scene_limits.h"

using Eigen::Vector2d;

namespace tests {
namespace {

/// The same with every weight moved that far, up or down and left or right by chance [m].
core::Scene nudged(core::Scene scene, double size, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto nudge = [&] { return random() % 2 == 0 ? size : -size; };
  for (core::Weight& weight : scene.weights) {
    const double x = nudge();
    weight.position += Vector2d(x, nudge());
    if (weight.rope) weight.rope->angle += nudge() / weight.rope->length;
  }
  return scene;
}

core::Run started(const core::Scene& scene, const core::Solver& solver) {
  return core::Run(std::make_shared<const core::Scene>(scene), solver);
}

}  // namespace

std::vector<std::tuple<core::EventKind, int, int>> stepEvents(const core::Run& run, bool isImage) {
  std::vector<std::tuple<core::EventKind, int, int>> events;
  for (const core::Event& event : run.stepEvents()) {
    core::EventKind kind = event.kind;
    if (isImage && event.kind == core::EventKind::kImpactWest) kind = core::EventKind::kImpactEast;
    if (isImage && event.kind == core::EventKind::kImpactEast) kind = core::EventKind::kImpactWest;
    events.emplace_back(kind, event.weight, event.other);
  }
  std::ranges::sort(events);
  return events;
}

double largestDistance(const core::Run& run, const std::function<Vector2d(int)>& place) {
  double largest = 0;
  for (int i = 0; i < run.weightCount(); ++i)
    largest = std::max(largest, (run.weight(i).position - place(i)).norm());
  return largest;
}

RunWithTwins::RunWithTwins(const core::Scene& scene, const core::Solver& solver, std::uint32_t seed)
    : run(started(scene, solver)) {
  // A ten-billionth of a meter, and what the last digits of places may be off by: the least
  // nudges find moments at which a rounding decides, such as two impacts at once.
  for (const double size : {1e-10, 1e-10, 1e-15, 2e-15, 4e-15, 8e-15}) {
    const core::Scene aside = nudged(scene, size, seed + 100 * static_cast<int>(m_twins.size()));
    if (core::problemsIn(aside).empty()) m_twins.push_back(started(aside, solver));
  }
}

bool RunWithTwins::advance() {
  const auto steps = [](core::Run& one) { return one.advance() == core::RunStatus::kRunning; };
  const bool goesOn = steps(run);
  for (core::Run& twin : m_twins) {
    m_isTold = m_isTold && steps(twin) == goesOn && stepEvents(twin) == stepEvents(run);
    m_uncertain =
        std::max(m_uncertain,
                 largestDistance(run, [&](int k) { return Vector2d(twin.weight(k).position); }));
  }
  return goesOn;
}

}  // namespace tests
