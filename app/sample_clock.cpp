#include "app/sample_clock.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

namespace {

/// How often `part` goes into `whole`, so that 0.1 goes three times into 0.3.
std::int64_t timesIn(double whole, double part) {
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  const double nearest = std::round(whole / part);
  const bool isMultiple = std::abs(nearest * part - whole) <= kRounding * whole;
  return static_cast<std::int64_t>(isMultiple ? nearest : std::floor(whole / part));
}

}  // namespace

SampleClock::SampleClock(double sample, double end)
    : m_sample(sample), m_end(end), m_last(timesIn(end, sample)) {}

bool SampleClock::isDue(double reached) const {
  return m_count <= m_last && moment() <= reached;
}

double SampleClock::moment() const {
  return std::min(static_cast<double>(m_count) * m_sample, m_end);
}

}  // namespace app
