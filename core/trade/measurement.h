#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/methods/method.h"
#include "core/run/run.h"
#include "core/scene/scene.h"
#include "core/trade/settings.h"
#include "core/trade/work_meter.h"

namespace core {

/// What one method at one setting got right, and what that cost.
struct MeasuredPoint {
  Solver solver;
  /// Of an adaptive method: of its own steps a weight took so many, as the mean of all weights
  /// and counted by slope evaluations.
  std::int64_t steps = 0;
  std::int64_t evaluations = 0;  ///< of slopes, of all weights together
  /// Largest distance of any weight from where it really is, at common moments [m].
  double maxPositionError = 0;
  double maxEnergyDrift = 0;                 ///< largest size of the numerical drift [J]
  double nanosecondsPerSimulatedSecond = 0;  ///< of computing; 0 if no time was simulated
  RunStatus status = RunStatus::kRunning;    ///< kRunning: it came to the end
  double reached = 0;                        ///< simulated time of the last good state [s]

  bool isComplete() const { return status == RunStatus::kRunning; }
};

/// All points of one method, the coarsest setting first.
struct MethodCurve {
  const Method* method = nullptr;
  std::vector<MeasuredPoint> points;
};

/// Speed against accuracy of several methods on one scene.
struct Measurement {
  double wanted = 0;  ///< simulated time that was asked for [s]
  /// Simulated time that was measured [s]: less where no computation knows the answer any more.
  double until = 0;
  double uncertainty = 0;  ///< of the positions that errors are measured against [m]
  int weightCount = 0;
  std::vector<MethodCurve> curves;

  bool endsEarly() const { return until < wanted; }
};

/// Measures each solver on the scene, in two threads at most.
///
/// Errors are taken against trustedCourse(), on the methods' own paths, at moments common to
/// all. Computing time is the processor time of a whole run without looking at it, the median of
/// several runs where they are short, after one that warms up.
///
/// @param solvers   each method's coarsest first
/// @param until     [s], ≥ 0
/// @param progress  may be empty
/// @return          nothing if the progress stopped it
/// @pre as for Run
std::optional<Measurement> measure(const std::shared_ptr<const Scene>& scene,
                                   const std::vector<Solver>& solvers, double until,
                                   const Progress& progress = {});

}  // namespace core
