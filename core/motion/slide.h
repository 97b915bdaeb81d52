#pragma once

#include <cmath>

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

 private:
  double m_friction;  // d μ g [m/s²]
  double m_drag;      // q [1/m]
  double m_heating;   // m q [kg/m]
};

}  // namespace core
