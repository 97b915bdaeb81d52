#include "core/trade/settings.h"

#include <cmath>
#include <string>

namespace core {

namespace {

/// So long that it does not get in the way of an adaptive method's own steps [s].
constexpr double kCommonStep = 0.5;

}  // namespace

double settingOf(const Solver& solver) {
  const Method* method = findMethod(solver.method);
  return method != nullptr && method->isAdaptive ? solver.tolerance : solver.step;
}

Solver solverWith(const Method& method, double setting) {
  Solver solver{.method = std::string(method.id)};
  if (method.isAdaptive) {
    solver.step = kCommonStep;
    solver.tolerance = setting;
  } else {
    solver.step = setting;
  }
  return solver;
}

std::vector<double> measuredSettings(const Method& method) {
  std::vector<double> settings;
  if (method.isAdaptive) {
    for (int power = 3; power <= 12; ++power) settings.push_back(1 / std::pow(10.0, power));
  } else {
    for (int power = 3; power <= 13; ++power) settings.push_back(std::ldexp(1, -power));
  }
  return settings;
}

std::vector<Solver> measuredSolvers() {
  std::vector<Solver> solvers;
  for (const Method& method : methods()) {
    for (const double setting : measuredSettings(method)) {
      solvers.push_back(solverWith(method, setting));
    }
  }
  return solvers;
}

}  // namespace core
