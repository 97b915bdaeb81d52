#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "core/recording/event_log.h"
#include "core/recording/ledger.h"
#include "core/recording/motion_log.h"
#include "core/run/run.h"
#include "core/run/run_state.h"

namespace core {

/// History of one run in bounded memory: its energies, its events, how weights move, and
/// enough states to restore every recorded step exactly.
///
/// States are kept every so many steps; when they outgrow the budget every other one is
/// dropped. A step between two of them is restored by taking the steps from the earlier
/// one again, which gives the same bits because a run is deterministic. What the user cuts
/// by hand is part of the record: states are kept as they were before the cuts of their step.
class Recording {
 public:
  /// @param budget  most memory for states [bytes]; two states are kept in any case
  explicit Recording(std::size_t budget = std::size_t{64} << 20) : m_budget(budget) {}

  /// Starts anew with the run as it is now.
  void start(const Run& run);

  /// Records the step the run has just taken; call after each advance() that succeeded. A
  /// step that is recorded already, as after restore(), stays as it is.
  void record(const Run& run);

  /// Takes the run's next step: again, with the cuts by hand that belong there, where it is
  /// recorded already; else anew, and records it.
  RunStatus advance(Run& run);
  /// What advance() does after the run's step, for a step that was taken elsewhere.
  /// @pre the run has just taken a step, from a recorded one
  void completeStep(Run& run);

  /// Cuts ropes by hand and remembers it. Everything recorded after the run's present step
  /// is forgotten: the future is another one now.
  void cutAll(Run& run);
  void cut(Run& run, int weight);
  /// Forgets everything recorded after the run's present step.
  void forgetAfter(const Run& run);

  /// Brings the run to that step, bit for bit as it was, with the paths of the step that
  /// led there.
  /// @pre firstStep() ≤ step ≤ lastStep()
  void restore(Run& run, std::int64_t step) const;

  // The same in pieces, for runs whose steps take long: after beginRestore() replay() leads to
  // the step, one step a call.

  /// Brings the run to the kept state that restore() starts from.
  /// @pre as for restore()
  void beginRestore(Run& run, std::int64_t step) const;
  /// Takes the next step of the record again.
  /// @pre the run stands at a recorded step before lastStep()
  void replay(Run& run) const;
  /// The step that beginRestore() starts from: before `step` unless that is the first.
  std::int64_t keptStepBefore(std::int64_t step) const;

  /// Lets motion() tell about this weight too: from now on at every step, about the past
  /// as far as states of it are kept.
  /// @param run  the recorded one
  void follow(const Run& run, int weight);

  std::int64_t firstStep() const { return m_firstStep; }
  std::int64_t lastStep() const { return m_lastStep; }

  const Ledger& ledger() const { return m_ledger; }
  const EventLog& eventLog() const { return m_events; }
  const MotionLog& motion() const { return m_motion; }

 private:
  struct HandCut {
    std::int64_t step;
    int weight;  // −1: all
  };

  void keep(const Run& run);
  void thinStates();
  void repeatCuts(Run& run) const;
  std::map<std::int64_t, RunState>::const_iterator keptBefore(std::int64_t step) const;

  std::size_t m_budget;
  std::size_t m_stateBytes = 0;
  std::int64_t m_stride = 1;  // steps between kept states
  std::int64_t m_firstStep = 0;
  std::int64_t m_lastStep = 0;
  std::map<std::int64_t, RunState> m_states;
  std::vector<HandCut> m_cuts;
  Ledger m_ledger;
  EventLog m_events;
  MotionLog m_motion;
};

}  // namespace core
