#include "core/recording/separation.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace core {
namespace {

constexpr double kSameMoment = 1e-9;  // of a step: multiples of two steps differ in last digits

std::size_t placeOfPair(std::size_t a, std::size_t b) {
  const auto [lower, upper] = std::minmax(a, b);
  return upper * (upper - 1) / 2 + lower;
}

bool goesOn(const Run& run) {
  return run.status() == RunStatus::kRunning;
}

}  // namespace

Separation separationOf(const Run& a, const Run& b, double time) {
  Separation separation{.time = time};
  for (int i = 0; i < a.weightCount(); ++i) {
    const double distance = (a.weightAt(i, time).position - b.weightAt(i, time).position).norm();
    if (separation.weight >= 0 && !(distance > separation.distance)) continue;
    separation.distance = distance;
    separation.weight = i;
  }
  return separation;
}

void SeparationLog::start(std::span<const Run* const> runs) {
  m_runCount = runs.size();
  m_pairs.assign(m_runCount * (m_runCount - (m_runCount > 0)) / 2, SeparationSeries(m_most));
  sample(runs, runs.empty() ? 0 : runs.front()->time());
}

void SeparationLog::note(std::span<const Run* const> runs) {
  assert(runs.size() == m_runCount);
  double earliest = std::numeric_limits<double>::infinity();
  double largestStep = 0;
  for (const Run* run : runs) {
    if (!goesOn(*run)) continue;
    earliest = std::min(earliest, run->time());
    largestStep = std::max(largestStep, run->solver().step);
  }
  if (largestStep == 0) return;
  if (earliest >= m_latest + (1 - kSameMoment) * largestStep) sample(runs, earliest);
}

void SeparationLog::sample(std::span<const Run* const> runs, double time) {
  m_latest = time;
  for (std::size_t b = 1; b < runs.size(); ++b)
    for (std::size_t a = 0; a < b; ++a)
      if (goesOn(*runs[a]) && goesOn(*runs[b]))
        m_pairs[placeOfPair(a, b)].append(separationOf(*runs[a], *runs[b], time));
}

void SeparationLog::dropAfter(double time) {
  for (SeparationSeries& pair : m_pairs) pair.dropAfter(time);
  m_latest = std::min(m_latest, time);
}

const SeparationSeries& SeparationLog::between(std::size_t a, std::size_t b) const {
  assert(a != b && std::max(a, b) < m_runCount);
  return m_pairs[placeOfPair(a, b)];
}

}  // namespace core
