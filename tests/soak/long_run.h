#pragma once

#include <functional>
#include <memory>

#include "core/scene/scene.h"
#include "tests/soak/process_figures.h"

/// Where a long run stands.
struct LongRunFigures {
  double time = 0;          ///< simulated [s]
  double drift = 0;         ///< energy unaccounted for, as a share of that at the start
  double overlap = 0;       ///< the deepest that two weights share, now [m]
  std::int64_t events = 0;  ///< so far
  ProcessFigures process;
};

/// Simulates a scene by Runge–Kutta 4 with 60 steps a second.
/// @param until       [s]
/// @param every       between calls of `report` [s]
/// @param isRecorded  with the history that the window keeps
/// @param report      called at the start as well
void runLong(const std::shared_ptr<const core::Scene>& scene, double until, double every,
             bool isRecorded, const std::function<void(const LongRunFigures&)>& report);

/// The demonstration's seven weights without air or friction, e = 1: cut, they never rest.
std::shared_ptr<const core::Scene> sevenThatNeverRest();

/// A heap that is poured and comes to rest.
std::shared_ptr<const core::Scene> pileThatRests();
