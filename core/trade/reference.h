#pragma once

#include "core/scene/scene.h"

namespace core {

/// How closely the reference follows the equations. What a step leaves out is less than the
/// rounding of places and angles: as close as numbers of 16 digits get.
inline constexpr double kReferenceTolerance = 1e-14;

/// The same a thousand times coarser. Where runs at both tolerances part, after impacts that
/// multiply every difference, neither can be trusted any more.
inline constexpr double kCoarseReferenceTolerance = 1e-11;

/// The reference's own error: its largest distance from the exact answers of all reference
/// cases, up to 10 s of swings, throws, bounces and ropes, is below this [m]. A test checks it.
inline constexpr double kReferenceError = 1e-12;

/// The solver of a run to trust: Taylor polynomials of degree 16 in steps of their own, which
/// end just at events and kinks.
///
/// Run, recording and views take it as any other; files and the command line do not know it.
///
/// @param step  [s] at whose multiples the run can be looked at, in kStepRange. In between it
///              is as exact, so that long steps do as well as short ones, and cost less.
/// @param tolerance  kReferenceTolerance or kCoarseReferenceTolerance
Solver referenceSolver(double step, double tolerance = kReferenceTolerance);

/// Whether a solver is one of those.
bool isReference(const Solver& solver);

}  // namespace core
