#include "ui/control/journey.h"

#include <algorithm>
#include <utility>

namespace ui {

void Journey::setGoal(double time, double goal) {
  m_start = time;
  m_goal = std::max(goal, 0.0);
  m_wanted = nullptr;
}

void Journey::setGoal(double time, double atMost, int run, EventFilter wanted) {
  setGoal(time, atMost);
  m_wanted = std::move(wanted);
  m_run = run;
}

void Journey::end() {
  m_goal.reset();
  m_aim.reset();
  m_wanted = nullptr;
}

double Journey::progress(const Lanes& lanes, double time) const {
  if (!m_goal) return 1;
  if (m_aim && m_stepsAtAim > 0) {
    return 1 - static_cast<double>(lanes.stepsToGo()) / static_cast<double>(m_stepsAtAim);
  }
  return *m_goal > m_start ? std::clamp((time - m_start) / (*m_goal - m_start), 0.0, 1.0) : 1;
}

Journey::Piece Journey::goOn(Lanes& lanes, double time, const HasTime& hasTime) {
  Piece piece{.time = time};
  if (restore(lanes, piece, hasTime)) compute(lanes, piece, hasTime);
  return piece;
}

/// @return  false if there is no time left, and more to restore
bool Journey::restore(Lanes& lanes, Piece& piece, const HasTime& hasTime) {
  const auto recordedGoal = [&] { return std::min(*m_goal, lanes.recordedUntil()); };
  while (m_aim || *m_goal < piece.time || lanes.isShorterByRecord(recordedGoal())) {
    if (!m_aim) {
      m_aim = recordedGoal();
      lanes.aimAt(*m_aim);
      m_stepsAtAim = lanes.stepsToGo();
    }
    if (!lanes.approach([&](const Lane&) { return hasTime(); })) return false;
    lanes.arrive();
    piece.time = *m_aim;
    piece.hasJumped = true;
    m_aim.reset();
  }
  return true;
}

// Once the event is found it is the goal, and the lanes that are still behind it go on.
void Journey::compute(Lanes& lanes, Piece& piece, const HasTime& hasTime) {
  bool isFound = false;
  do {
    lanes.advanceTo(*m_goal, [&](const Lane& lane) {
      isFound = finds(lanes, lane);
      return !isFound && hasTime();
    });
  } while (std::exchange(isFound, false));
  piece.time = lanes.timeReached(*m_goal);
  if (piece.time < *m_goal && lanes.canGoOn()) return;
  piece.hasFoundNothing = m_wanted != nullptr;
  end();
}

/// Whether the step that the lane has just taken holds the wanted event.
bool Journey::finds(const Lanes& lanes, const Lane& lane) {
  if (!m_wanted || &lane != &lanes[m_run]) return false;
  for (const core::Event& event : lane.run().stepEvents()) {
    if (event.time <= m_start || !m_wanted(event)) continue;
    setGoal(m_start, event.time);
    return true;
  }
  return false;
}

}  // namespace ui
