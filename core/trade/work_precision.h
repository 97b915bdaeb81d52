#pragma once

#include <optional>
#include <vector>

#include "core/trade/error_law.h"
#include "core/trade/measurement.h"

namespace core {

/// The step a point stands for [s]: the solver's own, or of an adaptive method the mean step of a
/// weight, counted by its slope evaluations.
double effectiveStep(const Measurement& measurement, const MeasuredPoint& point);

/// The points of a method that lie on a log–log chart: complete, with an error and a cost > 0.
std::vector<MeasuredPoint> chartedPoints(const MethodCurve& curve);

/// How the method's error falls with its effective step. Indices are into chartedPoints().
/// @return  nothing where the error follows no law at the settings measured
std::optional<ErrorLaw> errorLawOf(const Measurement& measurement, const MethodCurve& curve);

/// What it takes to keep the error below a bound over the time that was measured.
struct Reach {
  enum class Source {
    kInterpolated,  ///< between two points, on log–log paper
    kCoarsest,      ///< the coarsest setting measured does it: a coarser one may as well
    kExtrapolated,  ///< beyond all points, along the law the error was seen to follow
  };

  Source source;
  double setting;                        ///< step [s] or tolerance [-]
  double nanosecondsPerSimulatedSecond;  ///< of computing
};

/// @param error  bound of the position error [m], > 0
/// @return       nothing where no point reaches it and the error follows no law, and where the
///               bound is below what the reference solution can tell
std::optional<Reach> reach(const Measurement& measurement, const MethodCurve& curve, double error);

}  // namespace core
