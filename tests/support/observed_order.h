#pragma once

#include <vector>

#include "core/methods/method.h"
#include "tests/support/reference_case.h"

namespace tests {

/// Errors of a method at falling steps, and the order they show.
struct OrderMeasurement {
  std::vector<double> steps;   ///< [s], falling
  std::vector<double> errors;  ///< largest position error at each step [m]

  /// Slope of the straight line through log(error) over log(step), by least squares: what
  /// the position of an event within a step adds to one error alone evens out.
  double order() const;

  /// All of it in one line, for a failed test to show.
  QString text() const;
};

/// Runs the case once for each step.
OrderMeasurement measuredOrder(const ReferenceCase& reference, const core::Method& method,
                               std::vector<double> steps);

/// Steps from `coarsest` down to `finest` [s], evenly spaced on a logarithmic scale, no two
/// of them a simple fraction of each other: moments and events fall differently in each.
std::vector<double> stepLadder(double coarsest, double finest, int count);

}  // namespace tests
