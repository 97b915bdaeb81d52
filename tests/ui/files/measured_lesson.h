#pragma once

// What the figures of lessons are measured with.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/run/run.h"
#include "tests/support/played_lesson.h"
#include "ui/files/scene_file.h"

namespace tests {

constexpr double kDegree = std::numbers::pi / 180;

/// The lesson's scene as its sheet asks for it to be changed.
template <class Edit>
core::Scene changed(const char* lesson, Edit edit) {
  core::Scene scene = ui::builtInScene(lesson);
  edit(scene);
  return scene;
}

/// A run of it, played that far.
inline PlayedLesson played(const core::Scene& scene, std::size_t solver, double until) {
  PlayedLesson lesson(scene, solver);
  lesson.play(until);
  return lesson;
}
inline PlayedLesson played(const char* name, std::size_t solver, double until) {
  return played(ui::builtInScene(name), solver, until);
}

/// Lowest and highest of something over a run's steps.
struct Extent {
  double lowest = INFINITY;
  double highest = -INFINITY;

  void include(double value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
};

inline double driftPercent(const PlayedLesson& lesson) {
  return 100 * std::abs(*lesson.run().energies().driftShare());
}

inline double stepsPerSecond(const core::Scene& scene, std::size_t solver) {
  return 1 / scene.solvers[solver].step;
}

/// Looks at moments within the latest step too: what is extreme may be between two ends.
template <class Look>
void lookInside(const core::Run& run, Look look) {
  constexpr int kParts = 16;
  for (int part = 0; part < kParts; ++part) look(run.time() - part * run.solver().step / kParts);
}

}  // namespace tests
