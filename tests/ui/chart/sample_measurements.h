#pragma once

#include <cmath>
#include <memory>

#include "core/trade/measurement.h"

namespace sample_measurements {

/// A method whose error is factor · step^order [m] at steps 1/8, 1/16, …, and whose computing
/// takes 1 µs a step.
inline core::MethodCurve powerOfTheStep(const char* method, double factor, double order,
                                        int count = 8) {
  core::MethodCurve curve{core::findMethod(method), {}};
  for (int i = 0; i < count; ++i) {
    core::MeasuredPoint point;
    point.solver = core::solverWith(*curve.method, std::ldexp(1, -3 - i));
    point.maxPositionError = factor * std::pow(point.solver.step, order);
    point.nanosecondsPerSimulatedSecond = 1000 / point.solver.step;
    point.reached = 10;
    curve.points.push_back(point);
  }
  return curve;
}

/// Euler of order 1 and Runge–Kutta 4 of order 4, over 10 s.
inline std::shared_ptr<const core::Measurement> twoMethods() {
  core::Measurement measurement;
  measurement.wanted = measurement.until = 10;
  measurement.weightCount = 1;
  measurement.curves = {powerOfTheStep("euler", 2, 1), powerOfTheStep("rk4", 0.5, 4)};
  return std::make_shared<const core::Measurement>(std::move(measurement));
}

}  // namespace sample_measurements
