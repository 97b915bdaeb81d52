#include "ui/control/step_taker.h"

#include <chrono>
#include <cmath>
#include <memory>

namespace ui {
namespace {

constexpr double kPatience = 0.03;  // s: what is given up then was not worth much
constexpr double kSlow = 0.01;      // s: taken at once, frames would come late
constexpr double kQuick = 0.005;    // s: clearly less than slow, or threads would come and go
// A look at the clock costs as much as a small step.
constexpr int kQuestionsPerLook = 64;

/// Whether a step taken at once has run out of time.
struct Patience {
  const StepTaker::Stopwatch* stopwatch;
  double atMost;
  int questions = 0;
  double begin = 0;
  double passed = 0;  // at the latest look

  bool goesOn() {
    if (++questions % kQuestionsPerLook != 0 || std::isinf(atMost)) return true;
    const double now = (*stopwatch)();
    if (questions == kQuestionsPerLook) begin = now;
    passed = now - begin;
    return passed < atMost;
  }
};

}  // namespace

StepTaker::StepTaker(Stopwatch stopwatch, QObject* parent)
    : QObject(parent), m_stopwatch(std::move(stopwatch)), m_patience(kPatience) {
  connect(&m_task, &BackgroundTask::progressed, this,
          [this](int percent) { m_progress = percent / 100.0; });
}

bool StepTaker::take(Lane& lane, Lane::Step step) {
  if (m_lane && (m_lane != &lane || m_step != step)) giveUp();
  if (m_result) {
    giveBack(*std::exchange(m_result, std::nullopt));
    return true;
  }
  // It may be a step that was given up and has not noticed yet.
  if (m_task.isRunning()) return false;
  if (m_patience > 0 && !lane.isSlow() && takeHere(lane, step)) return true;
  takeElsewhere(lane, step);
  return false;
}

bool StepTaker::takeHere(Lane& lane, Lane::Step step) {
  Patience patience{&m_stopwatch, m_patience};
  const bool taken = lane.take(step, [&patience](double) { return patience.goesOn(); });
  lane.setSlow(!taken || patience.passed > kSlow);
  return taken;
}

void StepTaker::takeElsewhere(Lane& lane, Lane::Step step) {
  m_lane = &lane;
  m_step = step;
  m_progress = 0;
  const auto result = std::make_shared<Result>(Result{lane.lend(step), true});
  const auto work = [result](const core::Progress& progress) {
    const auto begin = std::chrono::steady_clock::now();
    result->run.tryAdvance(progress);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    result->wasSlow = passed.count() > kQuick;
  };
  m_task.start(work, [this, result] {
    m_result.emplace(std::move(*result));
    emit finished();
  });
}

void StepTaker::giveBack(Result result) {
  m_lane->setSlow(result.wasSlow);
  m_lane->giveBack(m_step, std::move(result.run));
  m_lane = nullptr;
}

void StepTaker::giveUp() {
  if (m_task.isRunning()) m_task.cancel();
  m_result.reset();
  m_lane = nullptr;
}

}  // namespace ui
