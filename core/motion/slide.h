#pragma once

#include <array>
#include <cmath>

#include "core/motion/series.h"
#include "core/motion/state.h"

namespace core {

/// How a weight that lies on the floor slides, until it stops.
///
/// State x = (x, v, Q): place along the floor [m], velocity [m/s], energy lost to air so
/// far [J].
///
///     x' = v
///     v' = −q |v| v − d μ g        d = +1 or −1: the way it slides when it starts
///     Q' = m q |v|³
///
/// The way is fixed so that no step crosses the jump of friction at v = 0: past that moment
/// the state means nothing, whoever steps it locates the moment.
/// Derivation: core/model.md, "Rest".
class Slide {
 public:
  /// @param friction  μ g, the deceleration on the floor [m/s²], ≥ 0
  /// @param way       d: +1 to the right, −1 to the left
  /// @param mass      m [kg]
  /// @param drag      q [1/m], see dragFactor()
  Slide(double friction, double way, double mass, double drag)
      : m_friction(friction * way), m_drag(drag), m_heating(mass * drag) {}

  /// dx/dt at x, entries in SI units per second.
  SlideState<> operator()(const SlideState<>& x) const {
    const double speed = std::abs(x[1]);
    SlideState<> slope;
    slope[0] = x[1];
    slope[1] = -m_drag * speed * x[1] - m_friction;
    slope[2] = m_heating * speed * speed * speed;
    return slope;
  }

  /// The solution through x as Taylor polynomials of (x, v, Q), |v| v as ± v² with the sign v
  /// has at the start: a stop is a root of v's polynomial.
  /// Derivation: core/model.md, "Taylor series".
  std::array<Series, 3> series(const SlideState<>& x) const {
    Series place{x[0]}, rate{x[1]}, heat{x[2]}, square{};
    const double way = std::copysign(1, x[1]);
    for (int k = 0; k < kSeriesDegree; ++k) {
      square[k] = productTerm(rate, rate, k);
      place[k + 1] = rate[k] / (k + 1);
      rate[k + 1] = (-way * m_drag * square[k] - (k == 0 ? m_friction : 0)) / (k + 1);
      heat[k + 1] = way * m_heating * productTerm(square, rate, k) / (k + 1);
    }
    return {place, rate, heat};
  }

 private:
  double m_friction;  // d μ g [m/s²]
  double m_drag;      // q [1/m]
  double m_heating;   // m q [kg/m]
};

}  // namespace core
