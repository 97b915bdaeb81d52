#pragma once

#include <QString>

namespace core {
struct Method;
struct Solver;
class Run;
}  // namespace core

namespace ui {

/// The method's name in the reader's language.
QString methodWords(const core::Method& method);

/// Method and step or tolerance: "Runge–Kutta 4, 1/60 s".
/// @pre the solver's method is known
QString runWords(const core::Solver& solver);

/// That a run has stopped, which, when and why; empty while it runs.
QString stopWords(const core::Run& run);

}  // namespace ui
