#include "core/run/step_clock.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace core {

namespace {

constexpr double kMeanSpan = 1;  // wall time over which the kept share is averaged [s]

}  // namespace

StepClock::StepClock(double longestFrame) : m_longestFrame(longestFrame) {
  assert(longestFrame > 0);
}

void StepClock::setSpeed(double speed) {
  assert(speed > 0);
  m_speed = speed;
}

void StepClock::reset(double time) {
  m_time = time;
  m_target = time;
  m_elapsed = 0;
  m_waited = 0;
  m_keptShare = 1;
}

double StepClock::keptShare() const {
  // While one step takes longer than the mean is taken over, it is less with every moment.
  return m_keptShare * kMeanSpan / std::max(m_waited, kMeanSpan);
}

double StepClock::targetAfter(double elapsed) {
  assert(elapsed >= 0);
  m_elapsed = m_waited + elapsed;
  m_target = m_time + std::min(m_elapsed, m_longestFrame) * m_speed;
  return m_target;
}

void StepClock::wait(double time) {
  assert(time <= m_target);
  const double part = m_target > m_time ? (time - m_time) / (m_target - m_time) : 0;
  const double rest = (1 - part) * m_elapsed;
  m_elapsed *= part;
  m_waited *= part;
  m_target = time;
  reached(time);
  m_waited = rest;
}

void StepClock::reached(double time) {
  assert(time <= m_target);
  if (m_elapsed > 0 && m_target > m_time) {
    const double frame = std::min(m_elapsed, m_longestFrame);
    const double share = (time - m_time) / (m_target - m_time) * (frame / m_elapsed);
    // One long pause weighs no more than one longest frame; a slow machine makes many.
    m_keptShare += (share - m_keptShare) * (1 - std::exp(-std::max(frame, m_waited) / kMeanSpan));
  }
  m_time = time;
  m_target = time;
  m_elapsed = 0;
  m_waited = 0;
}

}  // namespace core
