#pragma once

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
/// `Number` is double for one weight or Lanes<n> for a batch of n weights.
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
  template <class State>
  State operator()(const State& x) const {
    using Column = Eigen::Array<double, State::RowsAtCompileTime, 1>;
    const Column squaredSpeed = x.col(2) * x.col(2) + x.col(3) * x.col(3);
    const Column speed = squaredSpeed.sqrt();
    State slope;
    slope.col(0) = x.col(2);
    slope.col(1) = x.col(3);
    slope.col(2) = -m_drag * speed * x.col(2);
    slope.col(3) = -m_gravity - m_drag * speed * x.col(3);
    slope.col(4) = m_heating * speed * squaredSpeed;
    return slope;
  }

 private:
  double m_gravity;  // g [m/s²]
  Number m_drag;     // q [1/m]
  Number m_heating;  // m q [kg/m]
};

}  // namespace core
