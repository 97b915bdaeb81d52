#pragma once

#include "core/methods/method.h"
#include "core/methods/stages.h"

namespace core {

/// Forward Euler: the slope at the start is held for the whole step. Global error O(h).
struct ExplicitEuler {
  static constexpr Method kRow{.id = "euler",
                               .name = "Euler (explicit)",
                               .order = 1,
                               .slopesPerStep = 1,
                               .path = PathShape::kStraight};

  /// Pure: the result depends on the arguments alone.
  ///
  /// @param slope  f in dx/dt = f(x)
  /// @param x      state at the start: one weight's, or a batch's
  /// @param k1     f(x), known already
  /// @param h      step [s], finite and ≥ 0
  /// @return       the slope and the state at the end; non-finite if f was
  /// Source: Hairer, Nørsett & Wanner, Solving ODEs I, 2nd ed. (1993), §I.7.
  template <class Slope, class State>
  static Stages<State, 1> step(const Slope& /*slope*/, const State& x, const State& k1, double h) {
    return {{k1}, x + h * k1};
  }
};

}  // namespace core
