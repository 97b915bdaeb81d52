#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/aim/landing.h"
#include "core/run/run.h"
#include "core/run/run_state.h"
#include "core/trade/work_meter.h"

namespace core {

/// Finds where a weight lands for any cut time, without swinging from the start each time: one
/// run hangs on and leaves states behind, from which another goes on with its ropes cut.
///
/// A landing is what a run of the scene with that cut time shows, to the last bit.
class LandingFinder {
 public:
  /// The scene's own cut time does not matter.
  /// @param weight       index
  /// @param longestWait  for a landing, from the cut on [s], > 0
  /// @pre as for Run
  LandingFinder(const Scene& scene, const Solver& solver, int weight, double longestWait);

  /// Lets the ropes hang on up to this moment [s] or a little beyond.
  /// @param meter  asked whether to go on; nothing is counted
  /// @return       false if the meter stopped it
  bool hangUntil(double time, WorkMeter& meter);

  /// How far they hang [s]: less than was asked for where the run could not go on.
  double hungUntil() const { return m_hanging.time(); }

  /// @param cutTime  from 0 to hungUntil() [s]
  /// @return         nothing if the meter stopped it
  std::optional<Landing> landing(double cutTime, WorkMeter& meter) const;

 private:
  struct Kept {
    RunState state;
    std::size_t eventCount;  // up to there
  };

  void keep();
  Run runCutAt(double time) const;
  std::size_t keptBefore(double cutTime) const;
  bool asksNow(int step) const { return step % m_stepsUnasked == 0; }

  Scene m_scene;
  Solver m_solver;
  int m_weight;
  double m_longestWait;
  int m_stepsUnasked;  // between two questions whether to go on
  Run m_hanging;
  std::vector<Event> m_events;  // of the hanging run, that may matter
  std::vector<Kept> m_kept;     // every so many steps, from the start on
  std::int64_t m_stride = 1;
  std::size_t m_bytes = 0;
};

}  // namespace core
