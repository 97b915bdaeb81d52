#pragma once

#include <array>

namespace core {

/// Degree of the Taylor polynomials of the reference solution. Higher ones take longer steps,
/// but each costs the square: from 14 to 24 the work per second hardly changes.
inline constexpr int kSeriesDegree = 16;

/// Taylor polynomial of one quantity, a(t) = Σ a_k t^k, t since the moment it was expanded
/// at [s]: a_k in the quantity's unit per s^k.
using Series = std::array<double, kSeriesDegree + 1>;

/// Coefficient k of the product of two series, Σ a_j b_(k−j): needs theirs up to k.
///
/// The newest coefficients come last, so that the processor adds up the others while it still
/// waits for these: a step of a swing takes 430 ns instead of 520.
inline double productTerm(const Series& a, const Series& b, int k) {
  if (k == 0) return a[0] * b[0];
  double sum = 0;
  for (int j = 1; j < k; ++j) sum += a[j] * b[k - j];
  return sum + (a[0] * b[k] + a[k] * b[0]);
}

/// Coefficient k > 0 of the square root r of a series w, from r r = w: needs w's up to k and
/// r's below.
/// @pre r[0] = √w[0] > 0
inline double rootTerm(const Series& w, const Series& r, int k) {
  double rest = w[k];
  for (int j = 1; j < k; ++j) rest -= r[j] * r[k - j];
  return rest / (2 * r[0]);
}

}  // namespace core
