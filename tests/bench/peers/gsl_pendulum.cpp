#include <cmath>
#include <cstdlib>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <memory>

#include "tests/bench/peers/pendulum.h"

namespace bench {
namespace {

int slope(double /*time*/, const double x[], double result[], void* parameters) {
  const auto& pendulum = *static_cast<const Pendulum*>(parameters);
  result[0] = x[1];
  result[1] = -pendulum.pull * std::sin(x[0]) - pendulum.drag * std::abs(x[1]) * x[1];
  return GSL_SUCCESS;
}

template <auto kFree>
struct Free {
  template <class Handle>
  void operator()(Handle* handle) const {
    kFree(handle);
  }
};
using Step = std::unique_ptr<gsl_odeiv2_step, Free<gsl_odeiv2_step_free>>;
using Control = std::unique_ptr<gsl_odeiv2_control, Free<gsl_odeiv2_control_free>>;
using Evolve = std::unique_ptr<gsl_odeiv2_evolve, Free<gsl_odeiv2_evolve_free>>;

/// Bare steps, without the driver, which would take two halves to every step.
void solveBySteps(const Pendulum& pendulum, double rate, const Watch* watch) {
  Pendulum copy = pendulum;
  const gsl_odeiv2_system system{slope, nullptr, 2, &copy};
  const Step step(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 2));
  double state[2]{pendulum.angle, 0}, error[2];
  const auto steps = std::llround(pendulum.until * rate);
  for (std::int64_t i = 0; i < steps; ++i) {
    const double time = static_cast<double>(i) / rate;
    if (gsl_odeiv2_step_apply(step.get(), time, 1 / rate, state, error, nullptr, nullptr, &system))
      std::abort();
    if (watch) (*watch)(static_cast<double>(i + 1) / rate, state[0]);
  }
}

void solveByTolerance(const Pendulum& pendulum, double tolerance, const Watch* watch) {
  Pendulum copy = pendulum;
  const gsl_odeiv2_system system{slope, nullptr, 2, &copy};
  const Step step(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 2));
  const Control control(gsl_odeiv2_control_y_new(tolerance, tolerance));
  const Evolve evolve(gsl_odeiv2_evolve_alloc(2));
  double time = 0, length = 0.01;
  double state[2]{pendulum.angle, 0};
  while (time < pendulum.until) {
    if (gsl_odeiv2_evolve_apply(evolve.get(), control.get(), step.get(), &system, &time,
                                pendulum.until, &length, state)) {
      if (watch) (*watch)(time, INFINITY);  // cannot keep the tolerance
      return;
    }
    if (watch) (*watch)(time, state[0]);
  }
}

}  // namespace

std::vector<PendulumSolver> gslSolvers() {
  gsl_set_error_handler_off();
  return {{"GSL rk8pd, fixed", false, false, solveBySteps},
          {"GSL rk8pd", false, true, solveByTolerance}};
}

}  // namespace bench
