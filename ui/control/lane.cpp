#include "ui/control/lane.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {
namespace {

constexpr double kSameMoment = 1e-9;  // of a step: sums of steps differ in last digits

}  // namespace

Lane::Lane(std::shared_ptr<const core::Scene> scene, const core::Solver& solver)
    : m_scene(std::move(scene)), m_run(m_scene, solver) {
  m_recording.start(m_run);
}

double Lane::recordedUntil() const {
  return static_cast<double>(m_recording.lastStep()) * m_run.solver().step;
}

bool Lane::take(Step step, const core::Run::StepProgress& progress) {
  if (step == Step::kOnwards) {
    cutWhereDue();
    if (!m_run.tryAdvance(progress)) return false;
    completeStep();
  } else if (m_stepsToGo > 0) {
    if (!m_traveller->tryAdvance(progress)) return false;
    completeStepTowardsAim();
  }
  return true;
}

core::Run Lane::lend(Step step) {
  if (step == Step::kOnwards) {
    cutWhereDue();
    if (!m_traveller) m_traveller.emplace(m_scene, m_run.solver());
    m_traveller->restore(m_run.state());
  }
  core::Run lent = std::move(*m_traveller);
  m_traveller.reset();
  return lent;
}

void Lane::giveBack(Step step, core::Run run) {
  m_traveller.emplace(std::move(run));
  if (step == Step::kOnwards) {
    std::swap(m_run, *m_traveller);
    completeStep();
  } else {
    completeStepTowardsAim();
  }
}

/// After a step of m_run.
void Lane::completeStep() {
  if (!goesOn()) {
    m_isComplete = true;
    return;
  }
  m_recording.completeStep(m_run);
  cutWhereDue();
}

void Lane::completeStepTowardsAim() {
  --m_stepsToGo;
  if (m_traveller->status() == core::RunStatus::kRunning) m_recording.completeStep(*m_traveller);
}

bool Lane::canCut() const {
  const bool isUnderWay = m_cutAt && m_run.stepCount() == m_recording.lastStep();
  return goesOn() && !isUnderWay && !m_run.allCut();
}

void Lane::cutAt(double moment) {
  m_recording.forgetAfter(m_run);
  m_isComplete = false;
  m_isTravelling = false;
  m_cutAt = moment;
  cutWhereDue();
}

bool Lane::hasReached(double time) const {
  return m_run.time() >= time - kSameMoment * m_run.solver().step;
}

void Lane::cutWhereDue() {
  const bool isAtEnd = m_run.stepCount() == m_recording.lastStep();
  if (!m_cutAt || !isAtEnd || !hasReached(*m_cutAt)) return;
  m_recording.cutAll(m_run);
  m_cutAt.reset();
}

/// The recorded step whose end is the first that is not before `time`, or the last of all.
std::int64_t Lane::recordedStepAround(double time) const {
  const double step = m_run.solver().step;
  const auto last = static_cast<double>(m_recording.lastStep());
  auto around = static_cast<std::int64_t>(std::min(std::ceil(time / step), last));
  // The quotient may be a rounding error off.
  if (around < m_recording.lastStep() && static_cast<double>(around) * step < time) ++around;
  if (static_cast<double>(around - 1) * step >= time) --around;
  return std::max(around, m_recording.firstStep());
}

void Lane::aimAt(double time) {
  const std::int64_t aim = recordedStepAround(time);
  // Past its end the run stands as it stood when it stopped: one step more, which fails.
  const bool meansEnd = m_isComplete && time > recordedUntil();
  const bool isThere = m_run.stepCount() == aim && goesOn() && !meansEnd &&
                       (time >= m_run.time() || m_run.knowsLatestStep());
  m_isTravelling = !isThere;
  m_stepsToGo = 0;
  if (isThere) return;
  if (!m_traveller) m_traveller.emplace(m_scene, m_run.solver());
  if (m_run.stepCount() < aim && !isShorterByRecord(time)) {
    m_traveller->restore(m_run.state());
  } else {
    m_recording.beginRestore(*m_traveller, aim);
  }
  m_stepsToGo = aim - m_traveller->stepCount() + (meansEnd ? 1 : 0);
}

void Lane::arrive() {
  if (m_isTravelling) std::swap(m_run, *m_traveller);
  m_isTravelling = false;
}

bool Lane::isShorterByRecord(double time) const {
  return m_recording.keptStepBefore(recordedStepAround(time)) > m_run.stepCount();
}

}  // namespace ui
