#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "core/run/run.h"
#include "ui/files/scene_file.h"

namespace tests {

/// A run of a lesson, with all that has happened in it.
class PlayedLesson {
 public:
  explicit PlayedLesson(const core::Scene& scene, std::size_t solver = 0)
      : m_scene(std::make_shared<const core::Scene>(scene)),
        m_run(m_scene, m_scene->solvers[solver]) {}
  explicit PlayedLesson(const char* name, std::size_t solver = 0)
      : PlayedLesson(ui::builtInScene(name), solver) {}

  /// Goes on, looking at each step's end.
  template <class Look>
  void play(double until, Look look) {
    // Times of steps are rounded: a moment that is one of them is reached, not passed.
    const double last = until - 1e-9;
    while (m_run.time() < last && m_run.advance() == core::RunStatus::kRunning) {
      for (const core::Event& event : m_run.stepEvents()) m_events.push_back(event);
      look(m_run);
    }
  }
  void play(double until) {
    play(until, [](const core::Run&) {});
  }

  const core::Scene& scene() const { return *m_scene; }
  const core::Run& run() const { return m_run; }
  const std::vector<core::Event>& events() const { return m_events; }

  /// The first of this kind that happens to this weight; fails if there is none.
  const core::Event& first(core::EventKind kind, int weight) const {
    const auto found = std::ranges::find_if(m_events, [&](const core::Event& event) {
      return event.kind == kind && event.weight == weight;
    });
    if (found == m_events.end()) qFatal("no such event");
    return *found;
  }

  auto count(core::EventKind kind) const {
    return std::ranges::count(m_events, kind, &core::Event::kind);
  }

  /// Kinetic and potential energy now, as a share of that at the start.
  double energyShare() const { return m_run.energies().mechanical() / m_run.startEnergy(); }

 private:
  std::shared_ptr<const core::Scene> m_scene;
  core::Run m_run;
  std::vector<core::Event> m_events;
};

}  // namespace tests
