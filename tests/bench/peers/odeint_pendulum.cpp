#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "tests/bench/peers/pendulum.h"

namespace odeint = boost::numeric::odeint;

namespace bench {
namespace {

using State = std::array<double, 2>;

auto slopeOf(const Pendulum& pendulum) {
  return [pull = pendulum.pull, drag = pendulum.drag](const State& x, State& slope, double) {
    slope[0] = x[1];
    slope[1] = -pull * std::sin(x[0]) - drag * std::abs(x[1]) * x[1];
  };
}

auto observerOf(const Watch* watch) {
  return [watch](const State& x, double t) {
    if (watch) (*watch)(t, x[0]);
  };
}

template <class Stepper>
void solveByTolerance(const Pendulum& pendulum, double tolerance, const Watch* watch) {
  State state{pendulum.angle, 0};
  odeint::integrate_adaptive(odeint::make_controlled(tolerance, tolerance, Stepper()),
                             slopeOf(pendulum), state, 0.0, pendulum.until, 0.01,
                             observerOf(watch));
}

void solveByRungeKutta(const Pendulum& pendulum, double rate, const Watch* watch) {
  State state{pendulum.angle, 0};
  const auto steps = static_cast<std::size_t>(std::llround(pendulum.until * rate));
  odeint::integrate_n_steps(odeint::runge_kutta4<State>(), slopeOf(pendulum), state, 0.0, 1 / rate,
                            steps, observerOf(watch));
  if (!std::isfinite(state[0])) std::abort();  // and so the loop has to be run
}

}  // namespace

std::vector<PendulumSolver> odeintSolvers() {
  return {
      {"odeint rk4", false, false, solveByRungeKutta},
      {"odeint dopri5", false, true, solveByTolerance<odeint::runge_kutta_dopri5<State>>},
      {"odeint fehlberg78", false, true, solveByTolerance<odeint::runge_kutta_fehlberg78<State>>}};
}

}  // namespace bench
