#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/recording/separation.h"
#include "ui/control/lane.h"
#include "ui/control/step_taker.h"

namespace ui {

/// The runs of one scene with their records, kept at the same simulated moment. Where a step is
/// under way elsewhere they go no further for now, and go on when they are asked again.
class Lanes {
 public:
  /// Asked after each step, with the lane that took it: whether to go on.
  using GoOn = std::function<bool(const Lane&)>;

  Lanes() = default;
  /// One for each of the scene's solvers, at t = 0.
  /// @param steps  takes their steps; must outlive them
  Lanes(const std::shared_ptr<const core::Scene>& scene, StepTaker* steps);

  int count() const { return static_cast<int>(m_lanes.size()); }
  /// Stays at one address.
  const Lane& operator[](int index) const { return *m_lanes[index]; }

  /// Lets all recordings tell how this weight moves.
  void follow(int weight);

  bool canGoOn() const { return firstThatGoesOn() != nullptr; }
  /// How far the runs are apart over time.
  const core::SeparationLog& separations() const { return m_separations; }

  /// Null when none does.
  const Lane* firstThatGoesOn() const;
  bool canCut() const;
  /// See RunController::cutAll().
  void cutAll();

  /// Takes steps until all that go on have reached `target` [s], or `goOn` says no, or a step
  /// is under way. Always the lane that is furthest behind: so the latest steps of all have the
  /// earliest of their ends in common, and that moment can be shown whenever the work is broken
  /// off.
  void advanceTo(double target, const GoOn& goOn);
  /// As near to `target` [s] as all that go on have come; their last moment when none does.
  double timeReached(double target) const;
  /// How far all that can go on are recorded [s].
  double recordedUntil() const;

  // To another moment in pieces; see Lane.
  void aimAt(double time);
  /// Takes steps until all have come to where they were aimed, or `goOn` says no, or a step is
  /// under way.
  /// @return  true once nothing is left to do but arrive()
  bool approach(const GoOn& goOn);
  void arrive();
  std::int64_t stepsToGo() const;
  bool isShorterByRecord(double time) const;

 private:
  Lane* furthestBehind(double target);

  StepTaker* m_steps = nullptr;
  std::vector<std::unique_ptr<Lane>> m_lanes;
  std::vector<const core::Run*> m_runs;  // of the lanes
  core::SeparationLog m_separations;
};

}  // namespace ui
