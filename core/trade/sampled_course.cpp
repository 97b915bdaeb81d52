#include "core/trade/sampled_course.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr double kSamplesPerSecond = 200;
constexpr double kFewestIntervals = 2000;
constexpr double kMostPositions = 4e6;  // 64 MB

int intervalsFor(double until, int weightCount) {
  if (until <= 0) return 0;
  const double wanted = std::max(kFewestIntervals, std::ceil(until * kSamplesPerSecond));
  const double most = std::max(1.0, std::floor(kMostPositions / std::max(1, weightCount)));
  return static_cast<int>(std::min(wanted, most));
}

}  // namespace

SampleTimes::SampleTimes(double until, int weightCount)
    : m_until(until), m_intervals(intervalsFor(until, weightCount)) {}

double SampleTimes::at(int moment) const {
  return moment == 0 ? 0 : m_until * moment / m_intervals;
}

void SampledCourse::append(std::span<const Eigen::Vector2d> positions) {
  m_positions.insert(m_positions.end(), positions.begin(), positions.end());
  ++m_count;
}

std::span<const Eigen::Vector2d> SampledCourse::at(int moment) const {
  return std::span(m_positions)
      .subspan(static_cast<std::size_t>(moment) * m_weightCount, m_weightCount);
}

double largestDistance(std::span<const Eigen::Vector2d> a, std::span<const Eigen::Vector2d> b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

}  // namespace core
