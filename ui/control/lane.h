#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/recording/recording.h"
#include "core/run/run.h"

namespace ui {

/// One run with its record. Goes forward step by step, and to any recorded moment, with the
/// same bits whichever way it came.
class Lane {
 public:
  Lane(std::shared_ptr<const core::Scene> scene, const core::Solver& solver);

  /// Stays at one address, whatever moment it stands at.
  const core::Run& run() const { return m_run; }
  const core::Recording& recording() const { return m_recording; }

  /// Lets the record tell how this weight moves.
  void follow(int weight) { m_recording.follow(m_run, weight); }

  /// False once it stands where its numbers cannot go on.
  bool goesOn() const { return m_run.status() == core::RunStatus::kRunning; }
  /// End of the record [s].
  double recordedUntil() const;
  /// True if the record ends because the run cannot go on from there.
  bool isComplete() const { return m_isComplete; }

  /// What a lane can take a step of.
  enum class Step {
    kOnwards,    ///< the run, to its next step, recorded or new
    kTowardsAim  ///< the way to another moment: run() stays where it is
  };

  /// Takes the step unless `progress` gives it up. Where the run stops in it, or nothing is
  /// left to do but arrive(), that counts as taken.
  /// @return  false if it was given up: then all is as before
  bool take(Step step, const core::Run::StepProgress& progress);

  // A step that is taken elsewhere, in another thread as a rule: lend() gives away a run that
  // nobody else can reach; once its step is taken, giveBack() makes the lane what take() would
  // have made it. A run that never comes back leaves the lane as it was, a way to another moment
  // apart, which has to be aimed anew.

  core::Run lend(Step step);
  void giveBack(Step step, core::Run run);

  /// Whether steps took long the last time; told by those who take them.
  bool isSlow() const { return m_isSlow; }
  void setSlow(bool slow) { m_isSlow = slow; }

  /// False when no rope is left to cut, or a cut is already under way.
  bool canCut() const;
  /// Cuts all ropes at the first step's end from `moment` [s] on. What was recorded after
  /// the present step is forgotten: the future is another one now.
  void cutAt(double moment);

  // To another moment in pieces: aimAt(), steps towards the aim until none is left, arrive().
  // Until then run() stands where it was.

  /// @param time  [s], ≥ 0; where the run does not go so far, its last moment is meant
  void aimAt(double time);
  void arrive();
  /// Steps left to take.
  std::int64_t stepsToGo() const { return m_stepsToGo; }

  /// True if a state is kept between the present moment and `time` [s]: going there is then
  /// faster by aimAt() than by advance().
  bool isShorterByRecord(double time) const;

 private:
  std::int64_t recordedStepAround(double time) const;
  bool hasReached(double time) const;
  void cutWhereDue();
  void completeStep();
  void completeStepTowardsAim();

  std::shared_ptr<const core::Scene> m_scene;
  core::Run m_run;
  core::Recording m_recording;
  bool m_isComplete = false;
  std::optional<double> m_cutAt;  // ropes fall at the first step's end from here on [s]

  std::optional<core::Run> m_traveller;  // on its way to become m_run; none while it is lent
  std::int64_t m_stepsToGo = 0;
  bool m_isTravelling = false;
  bool m_isSlow = false;
};

}  // namespace ui
