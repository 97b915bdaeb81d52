#include "core/run/hit_wave.h"

#include <algorithm>

namespace core {
namespace {

// So often each row may be set right one by one before sweeps take over.
constexpr std::size_t kPatience = 8;
// Sweeps bring in new neighbours, which bring in others.
constexpr int kMostRounds = 10;

}  // namespace

Engine::HitWave::HitWave(Group& group, const ContactGoal& goal, double duration)
    : m_group(group), m_goal(goal), m_duration(duration) {
  addRows();
  for (int local = 0, hit = group.size(); local < hit; ++local) lookAround(local);
}

void Engine::HitWave::run() {
  for (int round = 0; round < kMostRounds; ++round) {
    if (!runThroughQueue())
      sweep();
    else if (!followBends())
      break;
  }
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    PushRow& row = m_rows[i];
    if (row.a == row.b) keepInside(row, m_group.weights[row.a].velocity);
    m_group.contacts[i].push = row.push;
  }
}

/// Finds the contacts of a member, for the speed it has now.
void Engine::HitWave::lookAround(int local) {
  if (!m_group.isExpanded(local)) m_group.expand(local);
  if (m_group.outruns(local)) m_group.lookFurther(local);
  addRows();
}

void Engine::HitWave::addRows() {
  for (std::size_t i = m_rows.size(); i < m_group.contacts.size(); ++i) {
    const RestingContact& contact = m_group.contacts[i];
    PushRow row = pushRow(contact, m_group.weights, m_duration);
    if (contact.b < 0) row.b = row.a;
    m_rows.push_back(row);
    m_waits.push_back(0);
    enqueue(static_cast<int>(i));
  }
}

void Engine::HitWave::enqueue(int row) {
  if (m_waits[row]) return;
  m_waits[row] = 1;
  m_queue.push_back(row);
}

/// @return  false when that takes too long
bool Engine::HitWave::runThroughQueue() {
  for (std::size_t count = 0; m_next < m_queue.size(); ++count) {
    if (count > kPatience * m_rows.size()) return false;
    const int row = m_queue[m_next++];
    m_waits[row] = 0;
    settle(row);
    tell(m_rows[row].a);
    if (m_rows[row].b != m_rows[row].a) tell(m_rows[row].b);
  }
  m_queue.clear();
  m_next = 0;
  return true;
}

/// @return  whether there is more to do, as weights on ropes bend towards others
bool Engine::HitWave::followBends() {
  if (!m_group.bend()) return false;
  takeGaps();
  return true;
}

void Engine::HitWave::takeGaps() {
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    const double speed = m_group.contacts[i].gap / m_duration;
    if (speed == m_rows[i].gapSpeed) continue;
    m_rows[i].gapSpeed = speed;
    enqueue(static_cast<int>(i));
  }
}

void Engine::HitWave::settle(int index) {
  PushRow& row = m_rows[index];
  core::settle(row, m_group.weights[row.a].velocity, m_group.weights[row.b].velocity);
  if (m_group.contacts[index].friction > 0) brake(index);
}

void Engine::HitWave::brake(int index) {
  RestingContact& contact = m_group.contacts[index];
  RestingWeight& weight = m_group.weights[contact.a];
  const Eigen::Vector2d tangent(-contact.normal.y(), contact.normal.x());
  const double most = contact.friction * m_rows[index].push;
  const double dragged =
      std::clamp(contact.drag - tangent.dot(weight.velocity) * weight.mass, -most, most);
  weight.velocity += (dragged - contact.drag) / weight.mass * tangent;
  contact.drag = dragged;
}

void Engine::HitWave::tell(int local) {
  if (!hasChanged(local)) return;
  m_group.told[local] = m_group.weights[local].velocity;
  lookAround(local);
  m_group.forEachContact(local, [&](int row) { enqueue(row); });
}

bool Engine::HitWave::hasChanged(int local) const {
  const Eigen::Vector2d change = m_group.weights[local].velocity - m_group.told[local];
  return change.squaredNorm() > m_goal.tolerance * m_goal.tolerance;
}

void Engine::HitWave::sweep() {
  for (std::size_t i = 0; i < m_rows.size(); ++i) m_group.contacts[i].push = m_rows[i].push;
  m_group.solve(m_goal);
  for (std::size_t i = 0; i < m_rows.size(); ++i) m_rows[i].push = m_group.contacts[i].push;
  while (m_next < m_queue.size()) m_waits[m_queue[m_next++]] = 0;
  takeGaps();
  addRows();
  for (int local = 0, count = m_group.size(); local < count; ++local) {
    if (!hasChanged(local)) continue;
    m_group.told[local] = m_group.weights[local].velocity;
    lookAround(local);
  }
}

}  // namespace core
