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

bool Lane::advance() {
  cutWhereDue();
  if (m_recording.advance(m_run) != core::RunStatus::kRunning) {
    m_isComplete = true;
    return false;
  }
  cutWhereDue();
  return true;
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
  m_aim = time;
  m_aimStep = recordedStepAround(time);
  const bool isThere = m_run.stepCount() == m_aimStep && goesOn();
  m_isTravelling = !isThere;
  if (isThere) return;
  if (!m_traveller) m_traveller.emplace(m_scene, m_run.solver());
  if (m_run.stepCount() < m_aimStep && !isShorterByRecord(time)) {
    m_traveller->restore(m_run.state());
  } else {
    m_recording.beginRestore(*m_traveller, m_aimStep);
  }
}

bool Lane::approach() {
  if (stepsToGo() > 0) m_recording.replay(*m_traveller);
  return stepsToGo() == 0;
}

void Lane::arrive() {
  if (m_isTravelling) std::swap(m_run, *m_traveller);
  m_isTravelling = false;
  // Past its end it stands as it stood when it stopped.
  if (m_isComplete && goesOn() && m_aim > m_run.time()) m_run.advance();
}

std::int64_t Lane::stepsToGo() const {
  return m_isTravelling ? m_aimStep - m_traveller->stepCount() : 0;
}

bool Lane::isShorterByRecord(double time) const {
  return m_recording.keptStepBefore(recordedStepAround(time)) > m_run.stepCount();
}

}  // namespace ui
