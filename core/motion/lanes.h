#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include <Eigen/Core>

namespace core {

/// Eight numbers, one per weight of a batch, that move through an equation together: the
/// scalar of a batch where `double` is that of one weight.
///
/// Every operation does to each number what it does to a double, so that a batch gives the
/// bits of single weights. How many of the eight one instruction takes is for the processor
/// the code is compiled for: see CORE_VECTOR_SPEED.
///
/// The alignment is said aloud: the compiler's own depends on the processor it compiles for,
/// and a batch made by code for the least of them is read by code for the best.
class alignas(64) Lanes {
 public:
  static constexpr int kCount = 8;

  Lanes() = default;
  /// The same number in every lane; implicit, as a constant in an equation stands for itself.
  Lanes(double all)  // NOLINT(google-explicit-constructor)
      : m_values(Values{} + all) {}

  double operator[](int lane) const { return m_values[lane]; }
  void set(int lane, double value) { m_values[lane] = value; }

  friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.m_values + b.m_values); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.m_values - b.m_values); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.m_values * b.m_values); }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.m_values / b.m_values); }
  friend Lanes operator-(const Lanes& a) { return Lanes(-a.m_values); }

  friend Lanes abs(const Lanes& a) { return fromBits(a.bits() & ~kSign); }
  friend Lanes sqrt(const Lanes& a) {
    Lanes root;
    for (int i = 0; i < kCount; ++i) root.m_values[i] = std::sqrt(a.m_values[i]);
    return root;
  }

  /// Whether every lane's magnitude is at most `bound`; false where one is not a number.
  friend bool allWithin(const Lanes& a, double bound) {
    const Bits inside = abs(a).m_values <= Values{} + bound;
    std::int64_t all = -1;
    for (int i = 0; i < kCount; ++i) all &= inside[i];
    return all != 0;
  }

  /// Per lane: `one` where bit 0 of `bits` is set, else `other`.
  friend Lanes chosenByBit0(const Lanes& bits, const Lanes& one, const Lanes& other) {
    const Bits mask = -(bits.bits() & 1);
    return fromBits((one.bits() & mask) | (other.bits() & ~mask));
  }
  /// Per lane: `a` with its sign turned where bit 1 of `bits` is set.
  friend Lanes turnedByBit1(const Lanes& bits, const Lanes& a) {
    return fromBits(a.bits() ^ ((bits.bits() << 62) & kSign));
  }

 private:
  using Values [[gnu::vector_size(64)]] = double;
  using Bits [[gnu::vector_size(64)]] = std::int64_t;
  static constexpr std::int64_t kSign = INT64_MIN;

  explicit Lanes(const Values& values) : m_values(values) {}
  static Lanes fromBits(const Bits& bits) { return Lanes(std::bit_cast<Values>(bits)); }
  Bits bits() const { return std::bit_cast<Bits>(m_values); }

  Values m_values;
};

static_assert(alignof(Lanes) == 64 && sizeof(Lanes) == 64);

inline bool allWithin(double a, double bound) {
  return std::abs(a) <= bound;
}
inline double chosenByBit0(double bits, double one, double other) {
  return (std::bit_cast<std::int64_t>(bits) & 1) != 0 ? one : other;
}
inline double turnedByBit1(double bits, double a) {
  const std::uint64_t sign = (std::bit_cast<std::uint64_t>(bits) << 62) & (std::uint64_t{1} << 63);
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(a) ^ sign);
}

}  // namespace core

// Before a function with a loop over batches: compiles it for several processors, with all
// it calls, and takes the best one this machine can run when the program starts. Not for
// fused multiply-add: its results differ in the last digit. Choosing takes a program of the form
// ELF, which Windows does not have, and comes too early for the thread sanitizer.
#if defined(__x86_64__) && defined(__ELF__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define CORE_VECTOR_SPEED [[gnu::target_clones("default", "avx2", "avx512f")]] [[gnu::flatten]]
#else
#define CORE_VECTOR_SPEED
#endif

template <>
struct Eigen::NumTraits<core::Lanes> : Eigen::GenericNumTraits<double> {
  using Real = core::Lanes;
  using NonInteger = core::Lanes;
  using Literal = core::Lanes;
  using Nested = core::Lanes;
};

template <class Operation>
struct Eigen::ScalarBinaryOpTraits<double, core::Lanes, Operation> {
  using ReturnType = core::Lanes;
};
template <class Operation>
struct Eigen::ScalarBinaryOpTraits<core::Lanes, double, Operation> {
  using ReturnType = core::Lanes;
};

/// Lanes are aligned as they need it already, more strictly than Eigen would ask for.
template <int kSize>
struct Eigen::internal::compute_default_alignment<core::Lanes, kSize> {
  enum { value = 0 };  // NOLINT(readability-identifier-naming): Eigen's name
};
