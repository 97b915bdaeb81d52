#pragma once

#include "core/methods/method.h"
#include "core/methods/stages.h"

namespace core {

/// Classical Runge–Kutta: a weighted mean of four slopes. Global error O(h⁴).
struct RungeKutta4 {
  static constexpr Method kRow{.id = "rk4",
                               .name = "Runge–Kutta 4",
                               .order = 4,
                               .slopesPerStep = 4,
                               .path = PathShape::kCubic};

  /// Pure: the result depends on the arguments alone.
  ///
  /// @param slope  f in dx/dt = f(x)
  /// @param x      state at the start: one weight's, or a batch's
  /// @param k1     f(x), known already
  /// @param h      step [s], finite and ≥ 0
  /// @return       the four slopes and the state at the end; non-finite if f was
  /// Source: Hairer, Nørsett & Wanner, Solving ODEs I, 2nd ed. (1993), §II.1.
  template <class Slope, class State>
  static Stages<State, 4> step(const Slope& slope, const State& x, const State& k1, double h) {
    const State k2 = slope(State(x + h / 2 * k1));
    const State k3 = slope(State(x + h / 2 * k2));
    const State k4 = slope(State(x + h * k3));
    return {{k1, k2, k3, k4}, x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)};
  }
};

}  // namespace core
