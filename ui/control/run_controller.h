#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <QObject>

#include "core/run/step_clock.h"
#include "ui/control/journey.h"
#include "ui/control/lanes.h"

namespace ui {

/// Plays the runs of one scene side by side: keeps them at the same simulated moment,
/// records them, goes back in their records, and stops those whose numbers cannot go on
/// while the others do.
///
/// All views show one moment, time(), and follow timeShown(). Going back changes no record:
/// playing on from there shows the same again, bit for bit, and then goes on computing. Only
/// a cut by hand forgets what was recorded after it.
///
/// Knows no wall clock but the stopwatch that bounds its work: time passes when passTime()
/// is called. Work that takes longer than a frame goes on with the next call; a single step
/// that does goes on in another thread (StepTaker), and the runs stay as they were until it has
/// ended. Emits each signal at most once per call.
class RunController : public QObject {
  Q_OBJECT

 public:
  /// Reads some clock [s]; only differences matter.
  using Stopwatch = StepTaker::Stopwatch;
  using EventFilter = Journey::EventFilter;

  explicit RunController(Stopwatch stopwatch, QObject* parent = nullptr);

  /// Bounds the work of a frame by another clock from now on; one that stands still does not
  /// bound it.
  void setStopwatch(Stopwatch stopwatch);
  /// See StepTaker.
  void setPatience(double seconds) { m_steps.setPatience(seconds); }
  /// With the computer's own steady clock.
  explicit RunController(QObject* parent = nullptr);
  ~RunController() override;

  /// Starts this scene at t = 0, one run for each of its solvers; goes on playing if it was.
  /// @pre problemsIn(*scene) is empty; it has 1 to kMostSolvers solvers of known methods
  void setScene(std::shared_ptr<const core::Scene> scene);
  const core::Scene& scene() const { return *m_scene; }

  /// Says again what there is to know, for those who begin to listen while the runs go on:
  /// restarted(), timeShown() and all that say what has changed.
  void tellAgain();

  int runCount() const { return m_lanes.count(); }
  /// Runs and recordings live until the next restarted().
  const core::Run& run(int index) const { return m_lanes[index].run(); }
  const core::Recording& recording(int index) const { return m_lanes[index].recording(); }
  std::vector<const core::Run*> runs() const;
  /// How far the runs are apart over time; lives as long as they do.
  const core::SeparationLog& separations() const { return m_lanes.separations(); }
  /// Lets all recordings tell how this weight moves.
  void follow(int weight);

  /// The moment shown [s]: inside the latest step of every run that still goes on.
  double time() const { return m_clock.time(); }
  /// How far all runs that can go on are recorded [s]: any moment from 0 to there can be
  /// shown without computing anything new.
  double recordedUntil() const { return m_lanes.recordedUntil(); }
  bool isPlaying() const { return m_playing; }
  /// False when every run has stopped.
  bool canGoOn() const { return m_lanes.canGoOn(); }
  /// False when no rope is left to cut, or a cut is already under way.
  bool canCut() const { return m_lanes.canCut(); }

  double speed() const { return m_clock.speed(); }
  /// Share of the wanted speed that is kept, 1 when it is.
  double keptShare() const;

  /// A step takes so long that it is under way in another thread.
  bool isStepUnderWay() const { return m_steps.isUnderWay(); }
  /// How long playing has been waiting for it [s].
  double waited() const { return m_playing ? m_clock.waited() : 0; }
  /// Share of it that is done, 0 to 1.
  double stepProgress() const { return m_steps.progress(); }

  /// Lets wall time pass: while playing, shows the moment that is due; while travelling,
  /// does some more of the work.
  /// @param elapsed  since the last call [s], ≥ 0
  void passTime(double elapsed);

  /// On the way to a moment that takes more work than fits a frame.
  bool isTravelling() const { return m_journey.isUnderWay(); }
  /// Where the way leads [s]; time() when not travelling, or to an event that is not found yet.
  double destination() const { return m_journey.goal().value_or(time()); }
  /// Share of the way that is done, 0 to 1.
  double travelProgress() const { return m_journey.progress(m_lanes, time()); }

  /// Goes on to the first event of this run that is wanted, after the moment shown, but not
  /// beyond `atMost` [s]; pauses first. Goes by what is recorded, and computes on where that
  /// ends.
  void goToNext(int run, EventFilter wanted, double atMost);
  /// Goes back to the last recorded event of this run that is wanted, before the moment shown;
  /// pauses first.
  void goToPrevious(int run, const EventFilter& wanted);

 public slots:
  void play();
  /// Stops playing, and travelling too.
  void pause();
  void togglePlaying();
  /// Shows another recorded moment, or the nearest there is; goes on playing if it was.
  /// @param time  [s]
  void showTime(double time);
  /// Goes to any moment, and computes what is not recorded yet; pauses first.
  /// @param time  [s], ≥ 0
  void goTo(double time);
  /// Ends travelling where it has come to.
  void stopTravelling();
  /// Ends whatever takes long: travelling, or else playing.
  void stopWork();
  /// Pauses, and shows the end of the next step of the first run that still goes on.
  void stepOnce();
  /// Pauses, and shows the end of the step before.
  void stepBack();
  /// Pauses, and goes on by what one frame of 1/60 s shows at the speed in force.
  void stepFrame();
  /// Pauses, and goes back by as much.
  void stepFrameBack();
  /// Cuts all ropes in all runs at one moment: the end of the latest step, or where runs
  /// with different steps are not at the same point, the first moment none has passed.
  /// Forgets what was recorded after that.
  void cutAll();
  /// Pauses, and starts again at t = 0.
  void reset();
  /// @param speed  simulated seconds per second, > 0
  void setSpeed(double speed);

 signals:
  /// All runs are new and stand at t = 0.
  void begun();
  /// Look at all runs anew: they have begun(), or somebody new listens.
  void restarted();
  /// Another moment is shown [s], or what is recorded has changed.
  void timeShown(double time);
  void playingChanged(bool playing);
  void speedChanged(double speed);
  /// A run has stopped, or goes on again because an earlier moment is shown: look at the
  /// runs' status.
  void runStatusChanged();
  /// canCut() is not what it was.
  void canCutChanged(bool canCut);
  /// passTime() has work to do from now on, or has none any more: playing or travelling.
  void busyChanged(bool busy);
  /// Travelling has begun, come on or ended.
  void travelled();
  /// Another frame was played: keptShare() and waited() are new.
  void framePassed();
  /// No event is wanted between these moments [s].
  void nothingFound(double from, double until);

 private:
  double now() const { return m_stopwatch(); }
  void goOn();
  void playOn(double elapsed);
  void travel(double budget);
  double stepOfFirst() const;
  void setPlaying(bool playing);
  void noteChanges();

  Stopwatch m_stopwatch;
  std::shared_ptr<const core::Scene> m_scene;
  StepTaker m_steps;
  Lanes m_lanes;
  core::StepClock m_clock;
  bool m_playing = false;
  Journey m_journey;
  double m_lastShown = 0;  // on the way, by the stopwatch [s]

  // As last told.
  bool m_couldCut = false;
  bool m_wasBusy = false;
  std::vector<bool> m_wentOn;
};

}  // namespace ui
