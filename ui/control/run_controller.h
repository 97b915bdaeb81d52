#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <QObject>

#include "core/recording/recording.h"
#include "core/run/run.h"
#include "core/run/step_clock.h"

namespace ui {

/// Plays the runs of one scene side by side: keeps them at the same simulated moment,
/// records them, and stops those whose numbers cannot go on while the others do.
///
/// Knows no wall clock but the stopwatch that bounds its work: time passes when passTime()
/// is called. Emits each signal at most once per call.
class RunController : public QObject {
  Q_OBJECT

 public:
  /// Reads some clock [s]; only differences matter.
  using Stopwatch = std::function<double()>;

  explicit RunController(Stopwatch stopwatch, QObject* parent = nullptr);

  /// Bounds the work of a frame by another clock from now on; one that stands still does not
  /// bound it.
  void setStopwatch(Stopwatch stopwatch) { m_stopwatch = std::move(stopwatch); }
  /// With the computer's own steady clock.
  explicit RunController(QObject* parent = nullptr);
  ~RunController() override;

  /// Starts this scene at t = 0, one run for each of its solvers; goes on playing if it was.
  /// @pre problemsIn(*scene) is empty; it has 1 to kMostSolvers solvers of known methods
  void setScene(std::shared_ptr<const core::Scene> scene);
  const core::Scene& scene() const { return *m_scene; }

  int runCount() const { return static_cast<int>(m_lanes.size()); }
  /// Runs and recordings live until the next restarted().
  const core::Run& run(int index) const;
  const core::Recording& recording(int index) const;
  std::vector<const core::Run*> runs() const;
  /// Lets all recordings tell how this weight moves.
  void follow(int weight);

  /// The moment shown [s]: inside the latest step of every run that still goes on.
  double time() const { return m_clock.time(); }
  bool isPlaying() const { return m_playing; }
  /// False when every run has stopped.
  bool canGoOn() const;
  /// False when no rope is left to cut, or a cut is already under way.
  bool canCut() const;

  double speed() const { return m_clock.speed(); }
  /// Share of the wanted speed that is kept, 1 when it is.
  double keptShare() const;

  /// Lets wall time pass: while playing, shows the moment that is due.
  /// @param elapsed  since the last call [s], ≥ 0
  void passTime(double elapsed);

 public slots:
  void play();
  void pause();
  void togglePlaying();
  /// Pauses, and shows the end of the next step of the first run that still goes on.
  void stepOnce();
  /// Pauses, and goes on by what one frame of 1/60 s shows at the speed in force.
  void stepFrame();
  /// Cuts all ropes in all runs at one moment: the end of the latest step, or where runs
  /// with different steps are not at the same point, the first moment none has passed.
  void cutAll();
  /// Pauses, and starts again at t = 0.
  void reset();
  /// @param speed  simulated seconds per second, > 0
  void setSpeed(double speed);

 signals:
  /// All runs are new and stand at t = 0.
  void restarted();
  /// Another moment is shown [s].
  void timeShown(double time);
  void playingChanged(bool playing);
  void speedChanged(double speed);
  /// A run has stopped: look at the runs' status.
  void runStopped();
  /// canCut() is not what it was.
  void canCutChanged(bool canCut);

 private:
  struct Lane;

  double now() const { return m_stopwatch(); }
  Lane* laneFurthestBehind(double target);
  bool advance(Lane& lane);
  void advanceTo(double target, double budget);
  double shownTime(double target) const;
  void cutWhereDue(Lane& lane);
  void setPlaying(bool playing);
  void noteCut();

  Stopwatch m_stopwatch;
  std::shared_ptr<const core::Scene> m_scene;
  std::vector<std::unique_ptr<Lane>> m_lanes;
  core::StepClock m_clock;
  bool m_playing = false;
  bool m_couldCut = false;
};

}  // namespace ui
