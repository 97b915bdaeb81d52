#pragma once

#include <vector>

#include "core/methods/method.h"
#include "core/scene/scene.h"

namespace core {

/// The number that says how finely a solver works: its step [s], or its tolerance [-] where the
/// method is adaptive.
double settingOf(const Solver& solver);

/// A solver of that method with that setting. Where it is a tolerance, the step at whose
/// multiples the run can be looked at is long.
Solver solverWith(const Method& method, double setting);

/// The settings a method is measured at, coarsest first: steps from 1/8 to 1/8192 s, each half
/// the one before; tolerances from 10⁻³ to 10⁻¹², each a tenth of it.
std::vector<double> measuredSettings(const Method& method);

/// All methods of the table at all their settings, method by method.
std::vector<Solver> measuredSolvers();

}  // namespace core
