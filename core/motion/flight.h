#pragma once

#include <cmath>

#include "core/motion/state.h"

namespace core {

/// How a weight flies: free, or inside the circle of its slack rope.
///
/// State x = (x, y, v_x, v_y, Q): center [m], velocity [m/s], energy lost to air so far [J].
///
///     x' = v_x        v_x' = −q |v| v_x           q = ρ c_d A / (2 m)
///     y' = v_y        v_y' = −g − q |v| v_y
///     Q' = m q |v|³
///
/// `Number` is double for one weight or Lanes for a batch.
/// Derivation: core/model.md, "Flight".
template <class Number = double>
class Flight {
 public:
  /// @param gravity  g [m/s²]
  /// @param mass     m [kg]
  /// @param drag     q [1/m], see dragFactor()
  Flight(double gravity, const Number& mass, const Number& drag)
      : m_gravity(gravity), m_drag(drag), m_heating(mass * drag) {}

  /// dx/dt at x, entries in SI units per second.
  FlightState<Number> operator()(const FlightState<Number>& x) const {
    using std::sqrt;
    const Number squaredSpeed = x[2] * x[2] + x[3] * x[3];
    const Number speed = sqrt(squaredSpeed);
    FlightState<Number> slope;
    slope[0] = x[2];
    slope[1] = x[3];
    slope[2] = -m_drag * speed * x[2];
    slope[3] = -m_gravity - m_drag * speed * x[3];
    slope[4] = m_heating * speed * squaredSpeed;
    return slope;
  }

 private:
  double m_gravity;  // g [m/s²]
  Number m_drag;     // q [1/m]
  Number m_heating;  // m q [kg/m]
};

}  // namespace core
