#pragma once

#include <cstdint>

namespace app {

/// The moments at which rows stand: 0, one sample, two samples, …, the end included where
/// it is a multiple.
class SampleClock {
 public:
  /// @param sample  time between rows [s], > 0
  /// @param end     [s], ≥ 0
  SampleClock(double sample, double end);

  /// Whether there is another moment, no later than `reached` [s].
  bool isDue(double reached) const;
  /// The moment to write a row for [s]: count × sample, because a sum would drift.
  double moment() const;
  void next() { ++m_count; }

 private:
  double m_sample;
  double m_end;
  std::int64_t m_last;
  std::int64_t m_count = 0;
};

}  // namespace app
