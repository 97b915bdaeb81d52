#pragma once

#include <vector>

#include <QString>

namespace core {
struct BoundedStep;
struct Measurement;
struct MethodCurve;
struct Reach;
struct Solver;
}  // namespace core

namespace ui {

/// Over what time was measured, and why not longer.
QString measuredTimeWords(const core::Measurement& measurement);

/// The method's name and the order that was observed: "Runge–Kutta 4: order 4.0".
QString orderWords(const core::Measurement& measurement, const core::MethodCurve& curve);

/// "1/64 s", or for an adaptive method its tolerance: "10⁻⁹".
QString settingWords(const core::Solver& solver);

/// What to set the method to, and what that costs, for one bound of the error: "a step of 1/30 s
/// and 2 µs of computing". Two digits are kept.
QString reachWords(const core::Measurement& measurement, const core::MethodCurve& curve,
                   const core::Reach& reach);

/// The largest step at which each method stays bounded over that time [s], in a sentence.
QString boundedStepWords(const std::vector<core::BoundedStep>& steps, double until);

/// What was found, in a sentence: what each method needs to be right within `error` [m].
QString foundWords(const core::Measurement& measurement, double error);

}  // namespace ui
