#pragma once

#include <Eigen/Core>

#include "core/motion/series.h"
#include "core/motion/state.h"

namespace core {

/// A weight's five entries as polynomials of time over a stretch: the path of methods that
/// know more of it than a cubic holds.
class Polynomial {
 public:
  /// @param coefficients  column k holds those of u^k, u = elapsed / duration from 0 to 1, in
  ///                      the entries' own units; 4 to kSeriesDegree + 1 columns
  /// @param duration      of the stretch [s], > 0
  using Coefficients =
      Eigen::Array<double, 5, Eigen::Dynamic, Eigen::ColMajor, 5, kSeriesDegree + 1>;
  Polynomial(Coefficients coefficients, double duration);

  /// @param elapsed  since the begin of the stretch [s], 0 to its duration
  FlightState<> at(double elapsed) const;
  /// d/dt there.
  FlightState<> rateAt(double elapsed) const;

  /// By how much each entry departs at most from Hermite's cubic, through both ends with both
  /// slopes, over a part of the stretch that long [s].
  FlightState<> bend(double duration) const;

 private:
  Coefficients m_coefficients;
  double m_duration;
  FlightState<> m_bend;  // over the whole stretch
};

}  // namespace core
