#include "core/trade/settings.h"

#include <cmath>
#include <string>

namespace core {

bool isAdaptive(const Method& /*method*/) {
  return false;
}

double settingOf(const Solver& solver) {
  const Method* method = findMethod(solver.method);
  return method != nullptr && isAdaptive(*method) ? solver.tolerance : solver.step;
}

Solver solverWith(const Method& method, double setting) {
  Solver solver{.method = std::string(method.id)};
  (isAdaptive(method) ? solver.tolerance : solver.step) = setting;
  return solver;
}

std::vector<double> measuredSettings(const Method& method) {
  std::vector<double> settings;
  if (isAdaptive(method)) {
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
