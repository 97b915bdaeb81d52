#include "ui/control/run_controller.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace ui {
namespace {

constexpr double kFrame = 1.0 / 60;         // s
constexpr double kPlayingBudget = 0.012;    // s of work per frame: leaves 4 ms for drawing
constexpr double kTravellingBudget = 0.03;  // s: keys and mouse are heard in between
constexpr double kFirstBudget = 0.1;        // s: what takes less counts as at once
constexpr double kShownEvery = 0.15;        // s: on the way drawing is not what time is for
constexpr double kSameMoment = 1e-9;        // of a step: sums of steps differ in last digits

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

RunController::RunController(Stopwatch stopwatch, QObject* parent)
    : QObject(parent), m_stopwatch(std::move(stopwatch)) {}

RunController::RunController(QObject* parent) : RunController(steadySeconds, parent) {}

RunController::~RunController() = default;

void RunController::setScene(std::shared_ptr<const core::Scene> scene) {
  endTravel();
  m_scene = std::move(scene);
  m_lanes = Lanes(m_scene);
  m_wentOn.assign(m_lanes.count(), true);
  m_clock.reset(0);
  emit restarted();
  emit timeShown(0);
  noteChanges();
}

std::vector<const core::Run*> RunController::runs() const {
  std::vector<const core::Run*> runs;
  runs.reserve(runCount());
  for (int i = 0; i < runCount(); ++i) runs.push_back(&run(i));
  return runs;
}

void RunController::follow(int weight) {
  m_lanes.follow(weight);
}

double RunController::keptShare() const {
  return m_playing ? m_clock.keptShare() : 1;
}

void RunController::passTime(double elapsed) {
  if (m_goal) {
    travel(kTravellingBudget);
  } else if (m_playing) {
    playOn(elapsed);
  }
}

void RunController::playOn(double elapsed) {
  const double target = m_clock.targetAfter(elapsed);
  const double deadline = now() + kPlayingBudget;
  m_lanes.advanceTo(target, [&](const Lane&) { return now() <= deadline; });
  m_clock.reached(m_lanes.timeReached(target));
  emit timeShown(time());
  noteChanges();
}

double RunController::travelProgress() const {
  if (!m_goal) return 1;
  if (m_aim && m_stepsAtAim > 0) {
    return 1 - static_cast<double>(m_lanes.stepsToGo()) / static_cast<double>(m_stepsAtAim);
  }
  return *m_goal > m_start ? std::clamp((time() - m_start) / (*m_goal - m_start), 0.0, 1.0) : 1;
}

void RunController::setGoal(double time) {
  m_goal = std::max(time, 0.0);
  m_wanted = nullptr;
  m_start = m_clock.time();
}

void RunController::travel(double budget) {
  const double deadline = now() + budget;
  const double before = time();
  const bool isRestored = restoreUntil(deadline);
  const bool hasJumped = time() != before;
  if (isRestored) computeUntil(deadline);
  const bool isOnTheWay = m_goal && !hasJumped && now() - m_lastShown < kShownEvery;
  if (!isOnTheWay && (time() != before || !m_goal)) {
    m_lastShown = now();
    emit timeShown(time());
  }
  noteChanges();
  emit travelled();
}

// What is recorded is restored: backwards always, forwards where a kept state makes the way
// shorter. A way that has been begun is finished before a new goal is looked at, so that the
// views follow a goal that moves on all the time.
bool RunController::restoreUntil(double deadline) {
  const auto recordedGoal = [this] { return std::min(*m_goal, recordedUntil()); };
  while (m_aim || *m_goal < time() || m_lanes.isShorterByRecord(recordedGoal())) {
    if (!m_aim) {
      m_aim = recordedGoal();
      m_lanes.aimAt(*m_aim);
      m_stepsAtAim = m_lanes.stepsToGo();
    }
    if (!m_lanes.approach([&](const Lane&) { return now() <= deadline; })) return false;
    m_lanes.arrive();
    m_clock.reset(*m_aim);
    m_aim.reset();
  }
  return true;
}

// Once the event is found it is the goal, and the lanes that are still behind it go on.
void RunController::computeUntil(double deadline) {
  bool isFound = false;
  do {
    m_lanes.advanceTo(*m_goal, [&](const Lane& lane) {
      isFound = isWanted(lane);
      return !isFound && now() <= deadline;
    });
  } while (std::exchange(isFound, false));
  m_clock.reset(m_lanes.timeReached(*m_goal));
  if (time() < *m_goal && canGoOn()) return;
  const bool isNothingFound = m_wanted != nullptr;
  endTravel();
  if (isNothingFound) emit nothingFound(m_start, time());
}

/// Whether the step that the lane has just taken holds the wanted event.
bool RunController::isWanted(const Lane& lane) {
  if (!m_wanted || &lane != &m_lanes[m_wantedRun]) return false;
  for (const core::Event& event : lane.run().stepEvents()) {
    if (event.time <= m_start || !m_wanted(event)) continue;
    setGoal(event.time);
    return true;
  }
  return false;
}

void RunController::endTravel() {
  m_goal.reset();
  m_aim.reset();
  m_wanted = nullptr;
}

void RunController::stopTravelling() {
  if (!m_goal) return;
  endTravel();
  emit timeShown(time());
  noteChanges();
  emit travelled();
}

void RunController::showTime(double time) {
  setGoal(std::min(time, recordedUntil()));
  travel(kFirstBudget);
}

void RunController::goTo(double time) {
  setPlaying(false);
  setGoal(time);
  travel(kFirstBudget);
}

void RunController::goToNext(int run, EventFilter wanted, double atMost) {
  setPlaying(false);
  const auto events = recording(run).eventLog().events();
  const auto later = std::ranges::upper_bound(events, time(), {}, &core::Event::time);
  const auto found = std::find_if(later, events.end(), wanted);
  setGoal(found == events.end() ? atMost : found->time);
  if (found == events.end()) {
    m_wanted = std::move(wanted);
    m_wantedRun = run;
  }
  travel(kFirstBudget);
}

void RunController::goToPrevious(int run, const EventFilter& wanted) {
  setPlaying(false);
  const auto events = recording(run).eventLog().events();
  const auto earlier = events.first(static_cast<std::size_t>(
      std::ranges::lower_bound(events, time(), {}, &core::Event::time) - events.begin()));
  const auto found = std::find_if(earlier.rbegin(), earlier.rend(), wanted);
  if (found != earlier.rend()) return goTo(found->time);
  emit nothingFound(
      events.empty() || recording(run).eventLog().forgotten() == 0 ? 0 : events.front().time,
      time());
}

void RunController::play() {
  setPlaying(canGoOn());
}

void RunController::pause() {
  stopTravelling();
  setPlaying(false);
}

void RunController::togglePlaying() {
  m_playing || m_goal ? pause() : play();
}

void RunController::setPlaying(bool playing) {
  if (playing == m_playing) return;
  m_playing = playing;
  emit playingChanged(playing);
  noteChanges();
}

/// Step of the first run that still goes on, or of the first [s].
double RunController::stepOfFirst() const {
  const Lane* first = m_lanes.firstThatGoesOn();
  return (first ? *first : m_lanes[0]).run().solver().step;
}

void RunController::stepOnce() {
  if (!canGoOn()) return setPlaying(false);
  const double step = stepOfFirst();
  goTo((std::floor(destination() / step + kSameMoment) + 1) * step);
}

void RunController::stepBack() {
  const double step = stepOfFirst();
  goTo((std::ceil(destination() / step - kSameMoment) - 1) * step);
}

void RunController::stepFrame() {
  if (!canGoOn()) return setPlaying(false);
  goTo(destination() + kFrame * speed());
}

void RunController::stepFrameBack() {
  goTo(destination() - kFrame * speed());
}

void RunController::cutAll() {
  if (!canCut()) return;
  const bool wasTravelling = isTravelling();
  endTravel();
  m_lanes.cutAll();
  emit timeShown(time());
  noteChanges();
  if (wasTravelling) emit travelled();
}

void RunController::reset() {
  pause();
  setScene(m_scene);
}

void RunController::setSpeed(double speed) {
  if (speed == m_clock.speed()) return;
  m_clock.setSpeed(speed);
  emit speedChanged(speed);
}

void RunController::noteChanges() {
  const bool couldCut = std::exchange(m_couldCut, canCut());
  if (canCut() != couldCut) emit canCutChanged(canCut());
  const bool isBusy = m_playing || m_goal;
  if (std::exchange(m_wasBusy, isBusy) != isBusy) emit busyChanged(isBusy);
  std::vector<bool> goesOn;
  for (int i = 0; i < runCount(); ++i) goesOn.push_back(m_lanes[i].goesOn());
  if (std::exchange(m_wentOn, goesOn) != goesOn) emit runStatusChanged();
  if (!canGoOn()) setPlaying(false);
}

}  // namespace ui
