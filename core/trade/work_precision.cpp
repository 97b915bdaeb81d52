#include "core/trade/work_precision.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace core {
namespace {

/// An error that many times the uncertainty is known well enough for a fit: the finer of the two
/// reference solutions is better than the two agree.
constexpr double kClear = 2;

/// Those that came to the end and took some time to compute.
std::vector<MeasuredPoint> completePoints(const MethodCurve& curve) {
  std::vector<MeasuredPoint> points;
  std::ranges::copy_if(curve.points, std::back_inserter(points), [](const MeasuredPoint& point) {
    return point.isComplete() && point.nanosecondsPerSimulatedSecond > 0;
  });
  return points;
}

/// Between two values, straight on log–log paper.
double between(double a, double b, double share) {
  return std::exp((1 - share) * std::log(a) + share * std::log(b));
}

Reach interpolated(const MeasuredPoint& coarse, const MeasuredPoint& fine, double error) {
  const double share = fine.maxPositionError == 0
                           ? 1
                           : std::log(coarse.maxPositionError / error) /
                                 std::log(coarse.maxPositionError / fine.maxPositionError);
  return {Reach::Source::kInterpolated,
          between(settingOf(coarse.solver), settingOf(fine.solver), share),
          between(coarse.nanosecondsPerSimulatedSecond, fine.nanosecondsPerSimulatedSecond, share)};
}

/// Along the law, from the finest point on. Each step costs what it does there; how a tolerance
/// goes with the step is taken from the two finest points.
std::optional<Reach> extrapolated(const Measurement& measurement, const MethodCurve& curve,
                                  double error) {
  const std::optional<ErrorLaw> law = errorLawOf(measurement, curve);
  if (!law) return std::nullopt;
  const std::vector<MeasuredPoint> points = chartedPoints(curve);
  const MeasuredPoint& a = points[points.size() - 2];
  const MeasuredPoint& b = points.back();
  const double stepA = effectiveStep(measurement, a), stepB = effectiveStep(measurement, b);
  const double step = law->stepFor(error);
  const double share = std::log(stepA / step) / std::log(stepA / stepB);
  return Reach{Reach::Source::kExtrapolated,
               between(settingOf(a.solver), settingOf(b.solver), share),
               b.nanosecondsPerSimulatedSecond * stepB / step};
}

}  // namespace

double effectiveStep(const Measurement& measurement, const MeasuredPoint& point) {
  const Method& method = *findMethod(point.solver.method);
  if (!method.isAdaptive) return point.solver.step;
  return point.reached * measurement.weightCount * method.slopesPerStep /
         static_cast<double>(point.evaluations);
}

std::vector<MeasuredPoint> chartedPoints(const MethodCurve& curve) {
  std::vector<MeasuredPoint> points = completePoints(curve);
  std::erase_if(points, [](const MeasuredPoint& point) { return point.maxPositionError == 0; });
  return points;
}

std::optional<ErrorLaw> errorLawOf(const Measurement& measurement, const MethodCurve& curve) {
  std::vector<CurvePoint> errors;
  for (const MeasuredPoint& point : chartedPoints(curve)) {
    errors.push_back({effectiveStep(measurement, point), point.maxPositionError});
  }
  return errorLaw(errors, kClear * measurement.uncertainty);
}

std::optional<Reach> reach(const Measurement& measurement, const MethodCurve& curve, double error) {
  std::vector<MeasuredPoint> points = completePoints(curve);
  if (points.empty() || error < measurement.uncertainty) return std::nullopt;
  // Finer settings than the best only gather more rounding.
  points.erase(std::ranges::min_element(points, {}, &MeasuredPoint::maxPositionError) + 1,
               points.end());
  // The last that misses: a coarser one that does not was lucky.
  const auto missing =
      std::find_if(points.rbegin(), points.rend(),
                   [&](const MeasuredPoint& point) { return point.maxPositionError > error; });
  if (missing == points.rend()) {
    return Reach{Reach::Source::kCoarsest, settingOf(points.front().solver),
                 points.front().nanosecondsPerSimulatedSecond};
  }
  if (missing != points.rbegin()) return interpolated(*missing, *std::prev(missing), error);
  return extrapolated(measurement, curve, error);
}

}  // namespace core
