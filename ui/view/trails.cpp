#include "ui/view/trails.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ui {
namespace {

constexpr double kLongestGap = 0.25;  // of the span: a straight line over more would be no trail

}  // namespace

double trailSpan(const core::Scene& scene) {
  if (scene.gravity <= 0) return 2;
  return 2.5 * std::sqrt(2 * scene.room.height / scene.gravity);
}

void Trails::reset(int runCount, int weightCount, double span) {
  assert(span > 0);
  m_runCount = runCount;
  m_weightCount = weightCount;
  const int trailCount = std::max(runCount * weightCount, 1);
  m_capacity = std::min(kMostPointsEach, kMostPoints / trailCount);
  if (m_capacity < kFewestPointsEach) m_capacity = 0;
  m_span = span;
  m_spacing = span / kMostPointsEach;
  m_times.assign(m_capacity, 0);
  m_positions.assign(static_cast<std::size_t>(m_capacity) * trailCount, {0, 0});
  clear();
}

void Trails::clear() {
  m_count = 0;
  m_newest = 0;
}

void Trails::forgetAfter(double time) {
  while (m_count > 0 && m_times[m_newest] > time) {
    m_newest = slotOf(1);
    --m_count;
  }
}

bool Trails::newestIsProvisional(double time) const {
  if (m_count == 0) return false;
  if (time == m_times[m_newest]) return true;
  // A hair of room, because frames of just the spacing come a rounding error early.
  return m_count > 1 && m_times[m_newest] - m_times[slotOf(1)] < 0.999 * m_spacing;
}

void Trails::record(double time, const std::vector<ShownRun>& runs) {
  if (m_capacity == 0) return;
  assert(static_cast<int>(runs.size()) == m_runCount);
  forgetAfter(time);
  if (m_count > 0 && time > m_times[m_newest] + kLongestGap * m_span) clear();
  if (!newestIsProvisional(time)) {
    m_newest = (m_newest + 1) % m_capacity;
    m_count = std::min(m_count + 1, m_capacity);
  }
  m_times[m_newest] = time;
  auto position = m_positions.begin() + m_newest * m_runCount * m_weightCount;
  for (const ShownRun& run : runs) {
    assert(static_cast<int>(run.weights.size()) == m_weightCount);
    for (const core::WeightState& weight : run.weights) *position++ = weight.position;
  }
}

std::vector<Eigen::Vector2d> Trails::points(int run, int weight) const {
  std::vector<Eigen::Vector2d> points;
  const int index = run * m_weightCount + weight;
  points.reserve(m_count);
  for (int age = m_count - 1; age >= 0; --age) {
    const int slot = slotOf(age);
    if (m_times[slot] < m_times[m_newest] - m_span) continue;
    points.push_back(m_positions[slot * m_runCount * m_weightCount + index]);
  }
  if (points.size() < 2) points.clear();
  return points;
}

}  // namespace ui
