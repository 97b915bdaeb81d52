#pragma once

#include "core/methods/method.h"
#include "core/methods/stages.h"

namespace core {

/// Dormand–Prince 5(4): order 5, with a solution of order 4 from the same slopes to tell the
/// error of each step, and a polynomial of order 4 in between. The seventh slope is the first
/// one of the next step.
///
/// Whoever takes the steps chooses them by the error; one step alone has error O(h⁶).
/// Source: Hairer, Nørsett & Wanner, Solving ODEs I, 2nd ed. (1993), table II.5.2 and §II.6.
struct DormandPrince {
  static constexpr Method kRow{.id = "dopri5",
                               .name = "Dormand–Prince 5(4)",
                               .order = 5,
                               .slopesPerStep = 7,
                               .path = PathShape::kQuartic,
                               .isAdaptive = true};

  /// Pure: the result depends on the arguments alone.
  ///
  /// @param slope  f in dx/dt = f(x)
  /// @param x      state at the start: one weight's, or one row per weight in a batch
  /// @param k1     f(x), known already
  /// @param h      step [s], finite and ≥ 0
  /// @return       the seven slopes, the last one at the end, and the state there; non-finite
  ///               if f was
  template <class Slope, class State>
  static Stages<State, 7> step(const Slope& slope, const State& x, const State& k1, double h) {
    const State k2 = slope(State(x + h * (1. / 5 * k1)));
    const State k3 = slope(State(x + h * (3. / 40 * k1 + 9. / 40 * k2)));
    const State k4 = slope(State(x + h * (44. / 45 * k1 - 56. / 15 * k2 + 32. / 9 * k3)));
    const State k5 = slope(State(
        x + h * (19372. / 6561 * k1 - 25360. / 2187 * k2 + 64448. / 6561 * k3 - 212. / 729 * k4)));
    const State k6 = slope(State(x + h * (9017. / 3168 * k1 - 355. / 33 * k2 + 46732. / 5247 * k3 +
                                          49. / 176 * k4 - 5103. / 18656 * k5)));
    const State end = x + h * (35. / 384 * k1 + 500. / 1113 * k3 + 125. / 192 * k4 -
                               2187. / 6784 * k5 + 11. / 84 * k6);
    return {{k1, k2, k3, k4, k5, k6, slope(end)}, end};
  }

  /// What the two solutions of order 5 and 4 differ by: the error of the worse one.
  template <class State>
  static State error(const Stages<State, 7>& stages, double h) {
    const auto& k = stages.slopes;
    return h * (71. / 57600 * k[0] - 71. / 16695 * k[2] + 71. / 1920 * k[3] -
                17253. / 339200 * k[4] + 22. / 525 * k[5] - 1. / 40 * k[6]);
  }

  /// The path inside the step is Hermite's cubic through both ends plus u² (1 − u)² times
  /// this, u = elapsed / h.
  template <class State>
  static State bulge(const Stages<State, 7>& stages, double h) {
    const auto& k = stages.slopes;
    return h * (-12715105075. / 11282082432 * k[0] + 87487479700. / 32700410799 * k[2] -
                10690763975. / 1880347072 * k[3] + 701980252875. / 199316789632 * k[4] -
                1453857185. / 822651844 * k[5] + 69997945. / 29380423 * k[6]);
  }
};

}  // namespace core
