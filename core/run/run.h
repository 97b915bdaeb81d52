#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/methods/method.h"
#include "core/motion/energy.h"
#include "core/run/event.h"
#include "core/run/phase.h"
#include "core/scene/scene.h"

namespace core {

/// One weight at one moment.
struct WeightState {
  Phase phase = Phase::kFlying;
  Eigen::Vector2d position{0, 0};  ///< of the center [m]
  Eigen::Vector2d velocity{0, 0};  ///< [m/s]
  double angle = 0;                ///< of the rope [rad]; only while tethered
  double angularVelocity = 0;      ///< [rad/s]; only while tethered
  double tension = 0;              ///< of the rope [N], pulling positive; 0 unless tethered
};

/// How a run stands.
enum class RunStatus : std::uint8_t {
  kRunning,
  kDiverged,  ///< numbers stopped being finite: the last finite state is kept
  kEndless,   ///< one step held more events than a step may: the state before it is kept
  kStalled,   ///< no step kept an adaptive method's tolerance, or it took too many: likewise
};

class Engine;
class RunState;

/// One scene × one method, step by step.
///
/// Deterministic: the same scene, solver and cuts give the same bits, however the calls
/// are spread over time and whatever is looked at in between.
class Run {
 public:
  /// @pre problemsIn(*scene) is empty; findMethod(solver.method) is not null; the solver's
  ///      step lies in kStepRange. An adaptive method takes its own steps, for every weight,
  ///      within that step: at its end all weights stand at the same moment.
  Run(std::shared_ptr<const Scene> scene, Solver solver);
  ~Run();
  Run(Run&&) noexcept;
  Run& operator=(Run&&) noexcept;

  const Scene& scene() const;
  const Solver& solver() const;
  const Method& method() const;
  int weightCount() const;

  /// Steps taken so far.
  std::int64_t stepCount() const;
  /// Simulated time: step count × step [s].
  double time() const;
  RunStatus status() const;

  /// Takes one step. Does nothing unless the status is kRunning. When the step fails the
  /// state, the time and the step count stay as they were before it.
  RunStatus advance();

  /// Cuts all ropes now, between two steps. Logged with the events of the coming step.
  void cutAll();
  /// Cuts one weight loose now, between two steps.
  void cut(int weight);
  /// True once no weight hangs on a rope any more.
  bool allCut() const;

  /// The weight now, at time().
  WeightState weight(int index) const;
  /// The weight at a moment inside the latest step, read from the step's own paths. An
  /// event at just that moment is over.
  /// @param time  [s], from the start of the latest step to time()
  WeightState weightAt(int index, double time) const;

  /// The whole scene's energies now, or at a moment inside the latest step.
  Energies energies() const;
  Energies energiesAt(double time) const;
  /// Kinetic + potential energy at t = 0 [J].
  double startEnergy() const;

  /// What happened in the latest step, in time order; cuts by hand before it included.
  std::span<const Event> stepEvents() const;

  /// Slope evaluations so far, repeated steps around events included.
  std::int64_t slopeEvaluations() const;

  /// Everything that decides how the run goes on. Copies share nothing.
  RunState state() const;
  /// Goes back (or forward) to a state taken from a run of the same scene and solver. The
  /// latest step is empty afterwards: weightAt() knows only the moment itself.
  void restore(const RunState& state);

 private:
  std::unique_ptr<Engine> m_engine;
};

}  // namespace core
