#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace core {

/// Coefficients of a polynomial of degree kDegree over u in [0, 1] in Bernstein form. The
/// curve stays within the range of its coefficients (convex hull property), which is what
/// makes "no root here" a matter of looking at signs.
/// Source: Farouki, The Bernstein polynomial basis, CAGD 29 (2012), §§3–5.
template <int kDegree>
using Bernstein = std::array<double, kDegree + 1>;

/// Binomial coefficient "n choose k" for the small n used here.
constexpr double binomial(int n, int k) {
  double result = 1;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

/// Value and derivative with respect to u, by de Casteljau's scheme.
template <int kDegree>
std::pair<double, double> valueAndSlope(Bernstein<kDegree> b, double u) {
  for (int level = kDegree; level > 1; --level)
    for (int i = 0; i < level; ++i) b[i] += u * (b[i + 1] - b[i]);
  return {b[0] + u * (b[1] - b[0]), kDegree * (b[1] - b[0])};
}

/// The same curve over [0, ½] and over [½, 1].
template <int kDegree>
std::pair<Bernstein<kDegree>, Bernstein<kDegree>> halves(Bernstein<kDegree> b) {
  Bernstein<kDegree> left, right;
  for (int level = kDegree; level >= 0; --level) {
    left[kDegree - level] = b[0];
    right[level] = b[level];
    for (int i = 0; i < level; ++i) b[i] = 0.5 * (b[i] + b[i + 1]);
  }
  return {left, right};
}

/// The polynomial divided by u; exact where the first coefficient is (or counts as) zero.
template <int kDegree>
Bernstein<kDegree - 1> withoutRootAtZero(const Bernstein<kDegree>& b) {
  Bernstein<kDegree - 1> quotient;
  for (int i = 0; i < kDegree; ++i) quotient[i] = b[i + 1] * kDegree / (i + 1);
  return quotient;
}

/// How often the coefficients change sign: at least the number of roots in (0, 1), and of
/// the same parity (Descartes).
template <int kDegree>
int signChanges(const Bernstein<kDegree>& b) {
  int changes = 0;
  bool negative = b[0] < 0;
  for (double coefficient : b) {
    if (coefficient == 0 || (coefficient < 0) == negative) continue;
    negative = !negative;
    ++changes;
  }
  return changes;
}

/// The one root of a polynomial that starts positive and ends negative or zero with a
/// single sign change: Newton's iteration, kept inside a bracket.
template <int kDegree>
double onlyRoot(const Bernstein<kDegree>& b) {
  double low = 0, high = 1;
  double u = b[0] / (b[0] - b[kDegree]);
  for (int i = 0; i < 100 && high - low > 1e-16; ++i) {
    const auto [value, slope] = valueAndSlope<kDegree>(b, u);
    if (value == 0) return u;
    (value > 0 ? low : high) = u;
    const double newton = slope < 0 ? u - value / slope : -1;
    const double next = low < newton && newton < high ? newton : 0.5 * (low + high);
    if (std::abs(next - u) < 1e-16) return next;
    u = next;
  }
  return u;
}

/// First u in [0, 1] at which the polynomial falls from positive to below −tolerance.
///
/// A dip that closes and opens again within the stretch is found; a dip shallower than
/// the tolerance is not one.
///
/// @param b          coefficients, finite; one that starts at or below −tolerance falls at 0
/// @param tolerance  ≥ 0, in the unit of the polynomial
/// @return           nothing if it never falls
template <int kDegree>
std::optional<double> firstFall(Bernstein<kDegree> b, double tolerance) {
  for (double& coefficient : b) coefficient += tolerance;
  if (b[0] <= 0) return 0.0;
  if (*std::min_element(b.begin(), b.end()) > 0) return std::nullopt;
  struct Stretch {
    Bernstein<kDegree> b;
    double begin;
    double width;
  };
  // Left halves first; a stack of one pending right half per level.
  constexpr int kDeepest = 48;
  std::array<Stretch, kDeepest + 2> stack;
  int waiting = 0;
  stack[waiting++] = {b, 0, 1};
  while (waiting > 0) {
    const Stretch here = stack[--waiting];
    if (here.b[0] <= 0) return here.begin;
    if (*std::min_element(here.b.begin(), here.b.end()) > 0) continue;
    if (signChanges<kDegree>(here.b) == 1)
      return here.begin + here.width * onlyRoot<kDegree>(here.b);
    if (waiting >= kDeepest) continue;  // a double root to the last digit: they only graze
    const auto [left, right] = halves<kDegree>(here.b);
    stack[waiting++] = {right, here.begin + here.width / 2, here.width / 2};
    stack[waiting++] = {left, here.begin, here.width / 2};
  }
  return std::nullopt;
}

}  // namespace core
