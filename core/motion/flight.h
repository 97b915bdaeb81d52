#pragma once

#include <array>
#include <cmath>

#include "core/motion/series.h"
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

  /// The solution through x as Taylor polynomials of (x, y, v_x, v_y, Q). Straight up or down
  /// |v| is ± v_y with the sign of the way the weight sets out: the top is a root of v_y's
  /// polynomial, beyond it the polynomials mean nothing.
  /// Derivation: core/model.md, "Taylor series".
  std::array<Series, 5> series(const FlightState<>& x) const {
    Series right{x[0]}, up{x[1]}, rateRight{x[2]}, rateUp{x[3]}, heat{x[4]};
    Series square{}, speed{};
    const bool straight = isStraight(x[2]);
    const double way = x[3] > 0 ? 1 : -1;
    for (int k = 0; k < kSeriesDegree; ++k) {
      square[k] = productTerm(rateUp, rateUp, k);
      if (!straight) square[k] += productTerm(rateRight, rateRight, k);
      speed[k] =
          straight ? way * rateUp[k] : (k == 0 ? std::sqrt(square[0]) : rootTerm(square, speed, k));
      right[k + 1] = rateRight[k] / (k + 1);
      up[k + 1] = rateUp[k] / (k + 1);
      rateRight[k + 1] = -m_drag * productTerm(speed, rateRight, k) / (k + 1);
      rateUp[k + 1] =
          (-m_drag * productTerm(speed, rateUp, k) - (k == 0 ? m_gravity : 0)) / (k + 1);
      heat[k + 1] = m_heating * productTerm(speed, square, k) / (k + 1);
    }
    return {right, up, rateRight, rateUp, heat};
  }

 private:
  /// So slow sideways that the drag of that speed is less than gravity's last digit.
  bool isStraight(double sideways) const {
    return m_drag * sideways * sideways <= 1e-16 * m_gravity;
  }

  double m_gravity;  // g [m/s²]
  Number m_drag;     // q [1/m]
  Number m_heating;  // m q [kg/m]
};

}  // namespace core
