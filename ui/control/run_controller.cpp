#include "ui/control/run_controller.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace ui {
namespace {

constexpr double kFrame = 1.0 / 60;         // s
constexpr double kPlayingBudget = 0.012;    // s of work per frame: leaves 4 ms for drawing
constexpr double kSlowBudget = 0.05;        // s, at most where drawing takes long
constexpr double kTravellingBudget = 0.03;  // s: keys and mouse are heard in between
constexpr double kFirstBudget = 0.1;        // s: what takes less counts as at once
constexpr double kShownEvery = 0.15;        // s: on the way drawing is not what time is for
constexpr double kSameMoment = 1e-9;        // of a step: sums of steps differ in last digits

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

RunController::RunController(Stopwatch stopwatch, QObject* parent)
    : QObject(parent), m_stopwatch(std::move(stopwatch)), m_steps(m_stopwatch) {
  connect(&m_steps, &StepTaker::finished, this, &RunController::goOn);
}

RunController::RunController(QObject* parent) : RunController(steadySeconds, parent) {}

RunController::~RunController() = default;

void RunController::setStopwatch(Stopwatch stopwatch) {
  m_steps.setStopwatch(stopwatch);
  m_stopwatch = std::move(stopwatch);
}

void RunController::setScene(std::shared_ptr<const core::Scene> scene) {
  m_journey.end();
  m_steps.giveUp();
  m_scene = std::move(scene);
  m_lanes = Lanes(m_scene, &m_steps);
  m_wentOn.assign(m_lanes.count(), true);
  m_clock.reset(0);
  emit begun();
  emit restarted();
  emit timeShown(0);
  noteChanges();
}

void RunController::tellAgain() {
  emit restarted();
  emit speedChanged(speed());
  emit playingChanged(m_playing);
  emit canCutChanged(canCut());
  emit timeShown(time());
  emit runStatusChanged();
  emit travelled();
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
  if (isTravelling()) {
    travel(kTravellingBudget);
  } else if (m_playing) {
    playOn(elapsed);
  }
}

/// A step that was waited for has ended: no need to wait for the next frame as well.
void RunController::goOn() {
  passTime(0);
}

void RunController::playOn(double elapsed) {
  const double target = m_clock.targetAfter(elapsed);
  // Half of the time where frames come late anyway: drawing must not starve the runs.
  const double deadline = now() + std::clamp(elapsed / 2, kPlayingBudget, kSlowBudget);
  m_lanes.advanceTo(target, [&](const Lane&) { return now() <= deadline; });
  const double before = time();
  const double reached = m_lanes.timeReached(target);
  m_steps.isUnderWay() ? m_clock.wait(reached) : m_clock.reached(reached);
  if (time() != before || !m_steps.isUnderWay()) {
    emit timeShown(time());
    noteChanges();
  }
  emit framePassed();
}

void RunController::travel(double budget) {
  const double deadline = now() + budget;
  const double before = time();
  const Journey::Piece piece = m_journey.goOn(m_lanes, before, [&] { return now() <= deadline; });
  m_clock.reset(piece.time);
  const bool isOnTheWay = isTravelling() && !piece.hasJumped && now() - m_lastShown < kShownEvery;
  if (!isOnTheWay && (time() != before || !isTravelling())) {
    m_lastShown = now();
    emit timeShown(time());
  }
  noteChanges();
  emit travelled();
  if (piece.hasFoundNothing) emit nothingFound(m_journey.start(), time());
}

void RunController::stopTravelling() {
  if (!isTravelling()) return;
  m_journey.end();
  m_steps.giveUp();
  emit timeShown(time());
  noteChanges();
  emit travelled();
}

void RunController::stopWork() {
  isTravelling() ? stopTravelling() : pause();
}

void RunController::showTime(double time) {
  m_journey.setGoal(m_clock.time(), std::min(time, recordedUntil()));
  travel(kFirstBudget);
}

void RunController::goTo(double time) {
  setPlaying(false);
  m_journey.setGoal(m_clock.time(), time);
  travel(kFirstBudget);
}

void RunController::goToNext(int run, EventFilter wanted, double atMost) {
  setPlaying(false);
  const auto events = recording(run).eventLog().events();
  const auto later = std::ranges::upper_bound(events, time(), {}, &core::Event::time);
  const auto found = std::find_if(later, events.end(), wanted);
  if (found == events.end()) {
    m_journey.setGoal(time(), atMost, run, std::move(wanted));
  } else {
    m_journey.setGoal(time(), found->time);
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
  m_playing || isTravelling() ? pause() : play();
}

void RunController::setPlaying(bool playing) {
  if (playing == m_playing) return;
  m_playing = playing;
  m_clock.reset(time());
  if (!playing) m_steps.giveUp();
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
  m_journey.end();
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
  const bool isBusy = m_playing || isTravelling();
  if (std::exchange(m_wasBusy, isBusy) != isBusy) emit busyChanged(isBusy);
  std::vector<bool> goesOn;
  for (int i = 0; i < runCount(); ++i) goesOn.push_back(m_lanes[i].goesOn());
  if (std::exchange(m_wentOn, goesOn) != goesOn) emit runStatusChanged();
  if (!canGoOn()) setPlaying(false);
}

}  // namespace ui
