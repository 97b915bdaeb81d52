#pragma once

#include <array>
#include <cmath>
#include <type_traits>

#include "core/motion/lanes.h"

namespace core {

/// sin x for one number or for a batch, to the same bits, right to one unit in the last
/// place [-].
///
/// x − n π/2 is found in two parts, with π/2 in three pieces: the first two times n have no
/// rounding; then Taylor's series on ±π/4, for the sine or the cosine as n is even or odd.
/// Angles of more than 1,300 turns are left to the standard library.
///
/// Measured: within 0.8 units in the last place of the exact value (tests/core/motion).
/// @param x  [rad]
template <class Number>
Number sine(const Number& x);

namespace detail {

// π/2 in three pieces: 40 bits, 40 bits, the rest.
constexpr double kHalfPi1 = 0x1.921fb54442p+0;
constexpr double kHalfPi2 = 0x1.a308d31318p-41;
constexpr double kHalfPi3 = 0x1.8a2e03707344ap-81;
constexpr double kFarthest = 8192;  // [rad]: n has 13 bits

/// x − n π/2 as a sum of two numbers, the second one being what the first cannot hold.
template <class Number>
struct Reduced {
  Number head, tail;
};

template <class Number>
[[gnu::always_inline]] inline Reduced<Number> reduced(const Number& x, const Number& n) {
  const Number rough = x - n * kHalfPi1;
  const Number second = n * kHalfPi2;
  const Number near = rough - second;
  const Number rest = n * kHalfPi3 - ((rough - near) - second);
  const Number head = near - rest;
  return {head, (near - head) - rest};
}

/// sin(x + tail) on ±π/4.
template <class Number>
Number sineNearZero(const Number& x, const Number& tail) {
  const Number z = x * x;
  const Number z2 = z * z, z4 = z2 * z2;
  // 1/5! − z/7! + …: pairs side by side, which takes half as long as one after another.
  const Number series =
      (1.0 / 120 - z * (1.0 / 5040)) + z2 * (1.0 / 362880 - z * (1.0 / 39916800)) +
      z4 * ((1.0 / 6227020800 - z * (1.0 / 1307674368000)) + z2 * (1.0 / 355687428096000));
  return x + (tail + x * z * (z * series - 1.0 / 6) - 0.5 * (z * tail));
}

/// cos(x + tail) on ±π/4.
template <class Number>
Number cosineNearZero(const Number& x, const Number& tail) {
  const Number z = x * x;
  const Number z2 = z * z, z4 = z2 * z2;
  const Number series =
      (1.0 / 24 - z * (1.0 / 720)) + z2 * (1.0 / 40320 - z * (1.0 / 3628800)) +
      z4 * ((1.0 / 479001600 - z * (1.0 / 87178291200)) + z2 * (1.0 / 20922789888000));
  const Number half = 0.5 * z;
  const Number head = 1.0 - half;
  return head + (((1.0 - head) - half) + (z2 * series - x * tail));
}

inline double cosineOf(const Reduced<double>& x) {
  return cosineNearZero(x.head, x.tail);
}

inline double librarySine(double x) {
  return std::sin(x);
}
/// Never inlined: eight sines more would make a batch's functions so large that the compiler
/// stops inlining what they are made of, and a step takes twice as long.
[[gnu::noinline]] inline void takeSinesOneByOne(std::array<double, Lanes::kCount>& angles) {
  for (double& angle : angles) angle = sine(angle);
}
inline Lanes librarySine(const Lanes& x) {
  std::array<double, Lanes::kCount> sines{};
  for (int i = 0; i < Lanes::kCount; ++i) sines[i] = x[i];
  takeSinesOneByOne(sines);
  Lanes result;
  for (int i = 0; i < Lanes::kCount; ++i) result.set(i, sines[i]);
  return result;
}

}  // namespace detail

// Inlined by force: a call would be to code for the least of processors.
template <class Number>
[[gnu::always_inline]] inline Number sine(const Number& x) {
  if (!allWithin(x, detail::kFarthest)) return detail::librarySine(x);
  // Adding 1.5·2⁵² rounds to a whole number and leaves it in the last bits.
  constexpr double kRound = 0x1.8p52;
  constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;
  const Number shifted = x * kTwoOverPi + kRound;
  const Number n = shifted - kRound;
  if constexpr (std::is_same_v<Number, double>) {
    // The same sums with n known beforehand: a processor that guesses the branch, as it can
    // on a swing, need not wait for n. 12 ns instead of 17, less than the standard library's.
    if (n == 0) return detail::sineNearZero(x, 0.0);
    if (n == 1) return detail::cosineOf(detail::reduced(x, 1.0));
    if (n == -1) return -detail::cosineOf(detail::reduced(x, -1.0));
  }
  const auto [head, tail] = detail::reduced(x, n);
  return turnedByBit1(shifted, chosenByBit0(shifted, detail::cosineNearZero(head, tail),
                                            detail::sineNearZero(head, tail)));
}

}  // namespace core
