#pragma once

#include <array>
#include <cmath>

#include "core/motion/series.h"
#include "core/motion/sine.h"
#include "core/motion/state.h"

namespace core {

/// How a weight swings on a taut rope or a rod, valid for any angle.
///
/// State x = (θ, ω, Q): angle from straight down, towards +x positive [rad]; angular
/// velocity [rad/s]; energy lost to air so far [J].
///
///     θ' = ω
///     ω' = −(g/L) sin θ − κ |ω| ω        κ = q L = ρ c_d A L / (2 m)
///     Q' = m κ L² |ω|³
///
/// `Number` is double for one weight or Lanes for a batch.
/// Derivation: core/model.md, "Swing".
template <class Number = double>
class Swing {
 public:
  /// @param gravity  g [m/s²]
  /// @param length   L of the rope [m]
  /// @param mass     m [kg]
  /// @param drag     q [1/m], see dragFactor()
  Swing(double gravity, const Number& length, const Number& mass, const Number& drag)
      : m_pull(gravity / length),
        m_drag(drag * length),
        m_heating(mass * m_drag * length * length) {}

  /// dx/dt at x, entries in SI units per second.
  SwingState<Number> operator()(const SwingState<Number>& x) const {
    using std::abs;
    const Number& omega = x[1];
    const Number speed = abs(omega);
    SwingState<Number> slope;
    slope[0] = omega;
    slope[1] = -m_pull * sine(x[0]) - m_drag * speed * omega;
    slope[2] = m_heating * speed * speed * speed;
    return slope;
  }

  /// The solution through x as Taylor polynomials of (θ, ω, Q), |ω| ω as ± ω² with the sign of
  /// the way the weight sets out: a root of ω is a root of the polynomial, beyond it the
  /// polynomials mean nothing.
  /// Derivation: core/model.md, "Taylor series".
  std::array<Series, 3> series(const SwingState<>& x) const {
    Series angle{x[0]}, rate{x[1]}, heat{x[2]};
    Series sine{std::sin(x[0])}, cosine{std::cos(x[0])}, square{};
    const double way = std::copysign(1, x[1] != 0 ? x[1] : -sine[0]);
    for (int k = 0; k < kSeriesDegree; ++k) {
      square[k] = productTerm(rate, rate, k);
      angle[k + 1] = rate[k] / (k + 1);
      rate[k + 1] = (-m_pull * sine[k] - way * m_drag * square[k]) / (k + 1);
      heat[k + 1] = way * m_heating * productTerm(square, rate, k) / (k + 1);
      sine[k + 1] = productTerm(cosine, rate, k) / (k + 1);
      cosine[k + 1] = -productTerm(sine, rate, k) / (k + 1);
    }
    return {angle, rate, heat};
  }

 private:
  Number m_pull;     // g/L [1/s²]
  Number m_drag;     // κ [-]
  Number m_heating;  // m κ L² [kg m²]
};

}  // namespace core
