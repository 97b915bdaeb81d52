#pragma once

#include <functional>
#include <optional>
#include <utility>

#include <QObject>

#include "ui/control/background_task.h"
#include "ui/control/lane.h"

namespace ui {

/// Takes steps of lanes: at once where that is quick, else in another thread, one at a time.
///
/// A step is begun at once. One that takes long is given up, and taken again by a run that is
/// lent to the other thread; steps after it are, too, until they have become quick. The window
/// never waits, and what it shows is never touched by the other thread.
class StepTaker : public QObject {
  Q_OBJECT

 public:
  /// Reads some clock [s]; only differences matter.
  using Stopwatch = std::function<double()>;

  explicit StepTaker(Stopwatch stopwatch, QObject* parent = nullptr);

  void setStopwatch(Stopwatch stopwatch) { m_stopwatch = std::move(stopwatch); }
  /// How long a step may take at once [s]; 0: every step is taken in the other thread, and with
  /// infinity none.
  void setPatience(double seconds) { m_patience = seconds; }

  /// Takes that step of the lane, or has it taken. Where another step is under way, that one is
  /// given up.
  /// @return  false while it is under way: ask for the same again after finished()
  bool take(Lane& lane, Lane::Step step);
  /// Gives up the step that is under way, if any: its lane is as before.
  void giveUp();
  /// A step has been begun and not been asked for since it ended.
  bool isUnderWay() const { return m_lane != nullptr; }
  /// Share of the step under way that is done, 0 to 1.
  double progress() const { return m_progress; }

 signals:
  /// The step under way has ended.
  void finished();

 private:
  struct Result {
    core::Run run;
    bool wasSlow;
  };

  bool takeHere(Lane& lane, Lane::Step step);
  void takeElsewhere(Lane& lane, Lane::Step step);
  void giveBack(Result result);

  Stopwatch m_stopwatch;
  double m_patience;
  Lane* m_lane = nullptr;  // whose step is under way
  Lane::Step m_step = Lane::Step::kOnwards;
  std::optional<Result> m_result;  // of that step
  double m_progress = 0;
  BackgroundTask m_task;  // last: it ends before anything else goes
};

}  // namespace ui
