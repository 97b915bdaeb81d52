#include "ui/control/run_controller.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

namespace ui {
namespace {

constexpr double kFrame = 1.0 / 60;       // s
constexpr double kPlayingBudget = 0.012;  // s of work per frame: leaves 4 ms for drawing
constexpr double kSteppingBudget = 0.25;  // s: a single step may take a noticeable while
constexpr double kSameMoment = 1e-9;      // of a step: sums of steps differ in last digits

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

/// One run with its record.
struct RunController::Lane {
  Lane(std::shared_ptr<const core::Scene> scene, const core::Solver& solver)
      : run(std::move(scene), solver) {
    recording.start(run);
  }

  bool goesOn() const { return run.status() == core::RunStatus::kRunning; }
  bool hasReached(double time) const {
    return run.time() >= time - kSameMoment * run.solver().step;
  }

  core::Run run;
  core::Recording recording;
  std::optional<double> cutAt;  // ropes fall at the first step's end from here on [s]
};

RunController::RunController(Stopwatch stopwatch, QObject* parent)
    : QObject(parent), m_stopwatch(std::move(stopwatch)) {}

RunController::RunController(QObject* parent) : RunController(steadySeconds, parent) {}

RunController::~RunController() = default;

void RunController::setScene(std::shared_ptr<const core::Scene> scene) {
  m_scene = std::move(scene);
  m_lanes.clear();
  for (const core::Solver& solver : m_scene->solvers) {
    m_lanes.push_back(std::make_unique<Lane>(m_scene, solver));
  }
  m_clock.reset(0);
  emit restarted();
  emit timeShown(0);
  noteCut();
}

const core::Run& RunController::run(int index) const {
  return m_lanes[index]->run;
}

const core::Recording& RunController::recording(int index) const {
  return m_lanes[index]->recording;
}

std::vector<const core::Run*> RunController::runs() const {
  std::vector<const core::Run*> runs;
  runs.reserve(m_lanes.size());
  for (const auto& lane : m_lanes) runs.push_back(&lane->run);
  return runs;
}

void RunController::follow(int weight) {
  for (const auto& lane : m_lanes) lane->recording.follow(lane->run, weight);
}

bool RunController::canGoOn() const {
  return std::any_of(m_lanes.begin(), m_lanes.end(),
                     [](const auto& lane) { return lane->goesOn(); });
}

bool RunController::canCut() const {
  return std::any_of(m_lanes.begin(), m_lanes.end(), [](const auto& lane) {
    return lane->goesOn() && !lane->cutAt && !lane->run.allCut();
  });
}

double RunController::keptShare() const {
  return m_playing ? m_clock.keptShare() : 1;
}

void RunController::passTime(double elapsed) {
  if (m_playing) advanceTo(m_clock.targetAfter(elapsed), kPlayingBudget);
}

/// The run with the earliest time, of those that have to go on to reach `target`.
RunController::Lane* RunController::laneFurthestBehind(double target) {
  Lane* furthest = nullptr;
  for (const auto& lane : m_lanes) {
    if (!lane->goesOn() || lane->run.time() >= target) continue;
    if (!furthest || lane->run.time() < furthest->run.time()) furthest = lane.get();
  }
  return furthest;
}

/// @return  false if the run has just stopped
bool RunController::advance(Lane& lane) {
  cutWhereDue(lane);
  if (lane.run.advance() != core::RunStatus::kRunning) return false;
  lane.recording.record(lane.run);
  cutWhereDue(lane);
  return true;
}

void RunController::cutWhereDue(Lane& lane) {
  if (!lane.cutAt || !lane.hasReached(*lane.cutAt)) return;
  lane.recording.cutAll(lane.run);
  lane.cutAt.reset();
}

// Always the run that is furthest behind: so the latest steps of all runs have the earliest
// of their ends in common, and that moment can be shown whenever the budget is used up.
void RunController::advanceTo(double target, double budget) {
  const double start = now();
  bool stopped = false;
  while (Lane* lane = laneFurthestBehind(target)) {
    stopped |= !advance(*lane);
    if (now() - start > budget) break;
  }
  const double shown = shownTime(target);
  m_clock.reached(shown);
  emit timeShown(shown);
  noteCut();
  if (stopped) emit runStopped();
  if (!canGoOn()) setPlaying(false);
}

/// As near to the target as all runs that go on have come; their last moment when none does.
double RunController::shownTime(double target) const {
  double earliest = std::numeric_limits<double>::infinity();
  double last = 0;
  for (const auto& lane : m_lanes) {
    if (lane->goesOn()) earliest = std::min(earliest, lane->run.time());
    last = std::max(last, lane->run.time());
  }
  return std::min(target, canGoOn() ? earliest : last);
}

void RunController::play() {
  setPlaying(canGoOn());
}

void RunController::pause() {
  setPlaying(false);
}

void RunController::togglePlaying() {
  m_playing ? pause() : play();
}

void RunController::setPlaying(bool playing) {
  if (playing == m_playing) return;
  m_playing = playing;
  emit playingChanged(playing);
}

void RunController::stepOnce() {
  pause();
  const auto first =
      std::find_if(m_lanes.begin(), m_lanes.end(), [](const auto& lane) { return lane->goesOn(); });
  if (first == m_lanes.end()) return;
  const core::Run& run = (*first)->run;
  const double step = run.solver().step;
  const bool isAtStepEnd = run.time() - time() <= kSameMoment * step;
  const double stepEnd = isAtStepEnd ? static_cast<double>(run.stepCount() + 1) * step : run.time();
  m_clock.reset(stepEnd);
  advanceTo(stepEnd, kSteppingBudget);
}

void RunController::stepFrame() {
  pause();
  if (!canGoOn()) return;
  const double target = time() + kFrame * speed();
  m_clock.reset(target);
  advanceTo(target, kSteppingBudget);
}

void RunController::cutAll() {
  if (!canCut()) return;
  double moment = 0;
  for (const auto& lane : m_lanes) {
    if (lane->goesOn()) moment = std::max(moment, lane->run.time());
  }
  for (const auto& lane : m_lanes) {
    if (!lane->goesOn() || lane->run.allCut()) continue;
    lane->cutAt = moment;
    cutWhereDue(*lane);
  }
  emit timeShown(time());
  noteCut();
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

void RunController::noteCut() {
  if (canCut() == m_couldCut) return;
  m_couldCut = canCut();
  emit canCutChanged(m_couldCut);
}

}  // namespace ui
