#include "core/trade/error_law.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

namespace core {
namespace {

constexpr std::array kGoodEnough{0.03, 0.1};  // root mean square of log error
constexpr std::size_t kFewestPoints = 4;
constexpr double kAboveFloor = 5;
constexpr double kFlattened = 0.5;  // of the steepest slope
constexpr double kLeastOrder = 0.5;
constexpr double kMostBend = 0.2;  // of the order, at the coarsest point

struct Fit {
  double order;
  double deviation;  ///< root mean square, of log error
  double bend;       ///< what the next power of the step adds to the slope at the coarsest point

  bool isGood(double most) const {
    return deviation <= most && order >= kLeastOrder && std::abs(bend) <= kMostBend * order;
  }
};

Fit fitted(std::span<const CurvePoint> points) {
  const auto count = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixX3d terms(count, 3);
  Eigen::VectorXd logErrors(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const CurvePoint& point = points[static_cast<std::size_t>(i)];
    // In units of the coarsest step, so that the three columns are of like size.
    terms.row(i) << 1, std::log(point.x), point.x / points.front().x;
    logErrors[i] = std::log(point.y);
  }
  const Eigen::Vector3d solution = terms.colPivHouseholderQr().solve(logErrors);
  const double squares = (terms * solution - logErrors).squaredNorm();
  return {solution[1], std::sqrt(squares / static_cast<double>(count)), solution[2]};
}

double slopeBetween(const CurvePoint& a, const CurvePoint& b) {
  return std::log(a.y / b.y) / std::log(a.x / b.x);
}

/// Errors below are rounding; 0 where none is.
double roundingFloor(std::span<const CurvePoint> curve) {
  if (curve.size() < 2) return 0;
  double steepest = 0, smallest = curve.front().y;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    steepest = std::max(steepest, slopeBetween(curve[i - 1], curve[i]));
    smallest = std::min(smallest, curve[i].y);
  }
  const double end = slopeBetween(curve[curve.size() - 2], curve.back());
  return end < kFlattened * steepest ? kAboveFloor * smallest : 0;
}

/// How many points from the start are above the floor.
std::size_t countAbove(std::span<const CurvePoint> curve, double floor) {
  const auto below =
      std::ranges::find_if(curve, [floor](const CurvePoint& point) { return point.y < floor; });
  return static_cast<std::size_t>(below - curve.begin());
}

/// The fit that ends before `end` and reaches back as far as it is good enough.
std::optional<ErrorLaw> lawUpTo(std::span<const CurvePoint> curve, std::size_t end, double good) {
  std::optional<ErrorLaw> law;
  for (std::size_t count = kFewestPoints; count <= end; ++count) {
    const Fit fit = fitted(curve.subspan(end - count, count));
    if (!fit.isGood(good)) break;
    law = ErrorLaw{fit.order, curve[end - 1].x, curve[end - 1].y, end - count, end - 1};
  }
  return law;
}

}  // namespace

double ErrorLaw::errorAt(double otherStep) const {
  return error * std::pow(otherStep / step, order);
}

double ErrorLaw::stepFor(double otherError) const {
  return step * std::pow(otherError / error, 1 / order);
}

std::optional<ErrorLaw> errorLaw(std::span<const CurvePoint> curve, double floor) {
  const std::size_t usable = countAbove(curve, std::max(floor, roundingFloor(curve)));
  for (const double good : kGoodEnough) {
    for (std::size_t end = usable; end >= kFewestPoints; --end) {
      const std::optional<ErrorLaw> law = lawUpTo(curve, end, good);
      if (law) return law;
    }
  }
  return std::nullopt;
}

}  // namespace core
