#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/methods/method.h"
#include "core/motion/energy.h"
#include "core/run/event.h"
#include "core/run/phase.h"
#include "core/run/step_stages.h"
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

  /// Asked now and then inside a step, with the share of it that is done, 0 to 1. Returns false
  /// to give the step up.
  using StepProgress = std::function<bool(double share)>;
  /// As advance(), but gives the step up once `progress` says so: the run then goes on from
  /// where it stood, to the same bits. It no longer knows its latest step.
  /// @return  false if the step was given up
  bool tryAdvance(const StepProgress& progress);
  /// Whether weightAt() knows more than the end of the latest step.
  bool knowsLatestStep() const;

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
  /// What has been done by hand since, or a cut at t = 0: stepEvents() of the coming step will
  /// begin with it.
  std::span<const Event> pendingEvents() const;

  /// The latest step of one weight, opened up: its parts in time order, one unless events
  /// divide it. None when no step was taken, or the run was just restored.
  std::vector<StepPart> latestStep(int index) const;
  /// The coming step likewise, with all that will happen in it; none if it fails. Takes the
  /// step of the whole scene, for the answer alone, unless `progress` gives it up.
  std::vector<StepPart> nextStep(int index, const StepProgress& progress = {}) const;
  /// What another method makes of the same part of a step: from the same state, over the
  /// same time, with no event.
  /// @param method  offered to users
  /// @pre part is of latestStep() or nextStep() of that weight, and the weight moves freely
  StepPart retaken(int index, const StepPart& part, const Method& method) const;
  /// The same part without a method's error, by the reference's Taylor polynomials.
  /// @param tolerance  of what each of them leaves out, see AdaptiveStepper; > 0
  /// @pre as for retaken()
  ExactWay exactWay(int index, const StepPart& part, double tolerance) const;

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
