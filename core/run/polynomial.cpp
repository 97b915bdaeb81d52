#include "core/run/polynomial.h"

namespace core {
namespace {

using Column = Eigen::Array<double, 5, 1>;

FlightState<> row(const Column& column) {
  return column.transpose();
}

/// Hermite's cubic is off by (duration)⁴/384 times the largest fourth derivative.
FlightState<> bendOf(const Polynomial::Coefficients& coefficients) {
  Column bend = Column::Zero();
  for (int k = 4; k < coefficients.cols(); ++k)
    bend += k * (k - 1) * (k - 2) * (k - 3) / 384.0 * coefficients.col(k).abs();
  return row(bend);
}

}  // namespace

Polynomial::Polynomial(Coefficients coefficients, double duration)
    : m_coefficients(std::move(coefficients)),
      m_duration(duration),
      m_bend(bendOf(m_coefficients)) {}

FlightState<> Polynomial::at(double elapsed) const {
  const double u = elapsed / m_duration;
  Column value = m_coefficients.rightCols<1>();
  for (Eigen::Index k = m_coefficients.cols() - 2; k >= 0; --k)
    value = value * u + m_coefficients.col(k);
  return row(value);
}

FlightState<> Polynomial::rateAt(double elapsed) const {
  const double u = elapsed / m_duration;
  Column rate = Column::Zero();
  for (Eigen::Index k = m_coefficients.cols() - 1; k >= 1; --k)
    rate = rate * u + static_cast<double>(k) * m_coefficients.col(k);
  return row(rate / m_duration);
}

FlightState<> Polynomial::bend(double duration) const {
  const double share = duration / m_duration;
  return share * share * share * share * m_bend;
}

}  // namespace core
