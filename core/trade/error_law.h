#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace core {

/// One point of a curve.
struct CurvePoint {
  double x;
  double y;

  bool operator==(const CurvePoint&) const = default;
};

/// How the error of a method falls with its step, as the step becomes small:
/// error → factor · step^order. A straight line on log–log paper.
struct ErrorLaw {
  double order = 0;       ///< the slope that was observed
  double step = 0;        ///< of the finest point it was fitted to [s]
  double error = 0;       ///< and that point's error [m]
  std::size_t first = 0;  ///< index of the coarsest point it was fitted to
  std::size_t last = 0;   ///< and of the finest

  /// Along the line, from the finest point on.
  double errorAt(double otherStep) const;
  /// @pre order > 0, otherError > 0
  double stepFor(double otherError) const;
};

/// Fits the law where a curve of errors [m] against steps [s] has become straight.
///
/// By least squares, log error = a + order · log step + b · step: the last term is what the next
/// power of the step adds, which fades slowly; it may change the slope by a fifth. Fitted are four
/// or more neighbouring points: the finest for which the fit is good to 3 %, or where there are
/// none to 10 %, and as many coarser ones as keep it so. Left out are
/// - errors below `floor`, and where the curve grows flat in the end (its last slope is under
///   half the steepest), errors below five times the smallest: rounding decides them;
/// - laws of an order under ½: there the error is so large that the step hardly matters.
///
/// @param curve  x: step, falling; y: error; both > 0
/// @param floor  [m]: errors below are not known well enough
/// @return       nothing where no part of the curve is straight
std::optional<ErrorLaw> errorLaw(std::span<const CurvePoint> curve, double floor);

}  // namespace core
