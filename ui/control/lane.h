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

  /// Takes the next step, recorded or new.
  /// @return  false if the run has just stopped
  bool advance();

  /// False when no rope is left to cut, or a cut is already under way.
  bool canCut() const;
  /// Cuts all ropes at the first step's end from `moment` [s] on. What was recorded after
  /// the present step is forgotten: the future is another one now.
  void cutAt(double moment);

  // To another moment in pieces: aimAt(), approach() until it returns true, arrive(). Until
  // then run() stands where it was.

  /// @param time  [s], ≥ 0; where the run does not go so far, its last moment is meant
  void aimAt(double time);
  /// Takes at most one step.
  /// @return  true once nothing is left to do but arrive()
  bool approach();
  void arrive();
  /// Steps left to take.
  std::int64_t stepsToGo() const;

  /// True if a state is kept between the present moment and `time` [s]: going there is then
  /// faster by aimAt() than by advance().
  bool isShorterByRecord(double time) const;

 private:
  std::int64_t recordedStepAround(double time) const;
  bool hasReached(double time) const;
  void cutWhereDue();

  std::shared_ptr<const core::Scene> m_scene;
  core::Run m_run;
  core::Recording m_recording;
  bool m_isComplete = false;
  std::optional<double> m_cutAt;  // ropes fall at the first step's end from here on [s]

  std::optional<core::Run> m_traveller;  // on its way to become m_run
  double m_aim = 0;                      // [s]
  std::int64_t m_aimStep = 0;
  bool m_isTravelling = false;
};

}  // namespace ui
