#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tests {

/// Choices made one after another by bytes; once those are used up, by zeros.
class Choices {
 public:
  explicit Choices(std::span<const std::uint8_t> bytes) : m_bytes(bytes) {}

  bool isUsedUp() const { return m_next >= m_bytes.size(); }
  std::uint8_t byte() { return isUsedUp() ? 0 : m_bytes[m_next++]; }
  bool bit() { return (byte() & 1) != 0; }
  /// @return  0 to `count` − 1
  int oneOf(int count) { return byte() % count; }
  /// @return  0 to 1, both included
  double share() {
    const int high = byte();
    return (high * 256 + byte()) / 65535.0;
  }

  /// A number from `lowest` to `highest`, in a way that is chosen, too: one of the ends, evenly
  /// between them, evenly between their orders of magnitude (of the highest 10⁶ at least), round,
  /// or the same as the number before, so that things coincide.
  double number(double lowest, double highest) {
    m_latest = freshNumber(lowest, highest);
    return m_latest;
  }

 private:
  double freshNumber(double lowest, double highest) {
    constexpr double kSmallest = 1e-6;
    constexpr int kRound = 16;
    switch (oneOf(8)) {
      case 0:
        return lowest;
      case 1:
        return highest;
      case 2:
      case 3: {
        const double low = lowest > 0 ? lowest : kSmallest * highest;
        return low * std::pow(highest / low, 0.999999 * share());
      }
      case 4:
        return lowest + (highest - lowest) * (oneOf(kRound + 1) / double{kRound});
      case 5:
        if (lowest <= m_latest && m_latest <= highest) return m_latest;
        [[fallthrough]];
      default:
        return lowest + (highest - lowest) * share();
    }
  }

  std::span<const std::uint8_t> m_bytes;
  std::size_t m_next = 0;
  double m_latest = 0;
};

}  // namespace tests
