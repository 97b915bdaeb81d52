#pragma once

#include "core/contact/contact_problem.h"

namespace core {

/// Solves contacts one after the other, over and over (projected Gauss–Seidel), with
/// conjugate directions laid over the sweeps: a plain sweep carries a push one layer further.
///
/// Velocities must hold what the rows' impulses do, and still do afterwards.
///
/// @return  false if the bound on the sweeps ended it, or going on would have changed nothing
/// Source: Jean, The non-smooth contact dynamics method, CMAME 177 (1999), §4;
/// Silcowitz, Niebe & Erleben, A nonsmooth nonlinear conjugate gradient method for
/// interactive contact force problems, The Visual Computer 26 (2010), §3.
bool solveBySweeps(ContactProblem& problem, const ContactGoal& goal);

}  // namespace core
