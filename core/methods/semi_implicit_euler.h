#pragma once

#include <type_traits>

#include "core/methods/method.h"
#include "core/methods/stages.h"
#include "core/motion/state.h"

namespace core {

/// Semi-implicit (symplectic) Euler: first the rates by the slope at the start, then the
/// places by the new rates. Global error O(h), but the energy of a swing without air neither
/// grows nor falls for long.
struct SemiImplicitEuler {
  static constexpr Method kRow{.id = "semi-implicit-euler",
                               .name = "Euler (semi-implicit)",
                               .order = 1,
                               .slopesPerStep = 1,
                               .path = PathShape::kParabola};

  /// Pure: the result depends on the arguments alone.
  ///
  /// @param slope  f in dx/dt = f(x)
  /// @param x      state at the start, entries as core/motion/state.h orders them: places,
  ///               their rates, energy. A number alone has no rate: it takes Euler's step.
  /// @param k1     f(x), known already
  /// @param h      step [s], finite and ≥ 0
  /// @return       the slope and the state at the end; non-finite if f was
  /// Source: Hairer, Lubich & Wanner, Geometric Numerical Integration, 2nd ed. (2006), §I.1.
  template <class Slope, class State>
  static Stages<State, 1> step(const Slope& /*slope*/, const State& x, const State& k1, double h) {
    State end = x + h * k1;
    if constexpr (!std::is_arithmetic_v<State>)
      for (int i = 0; i < kPlaces<State>; ++i)
        end.col(i) = x.col(i) + h * end.col(kPlaces<State> + i);
    return {{k1}, end};
  }
};

}  // namespace core
