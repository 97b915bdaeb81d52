#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

namespace core {

/// Something the paths say will happen within the present step.
struct Upcoming {
  enum class Kind : std::uint8_t {
    kCut,
    kWeight,  ///< two weights meet
    kFloor,
    kCeiling,
    kWest,
    kEast,
    kTurningPoint,
    kApex,  ///< the speed passes (nearly) zero in flight
    kSlack,
    kTaut,
    kStop,     ///< a sliding weight stops
    kSettle,   ///< forces in groups at rest are found anew
    kOwnStep,  ///< an adaptive method begins the weight's next step
  };

  double time;  ///< from the start of the step [s]
  int weight;   ///< −1 for a cut and kSettle
  int other;    ///< second weight of kWeight, else −1
  Kind kind;
  bool pressing;             ///< see Contact
  std::uint32_t stamp;       ///< of the weight's piece when this was foreseen
  std::uint32_t otherStamp;  ///< of the second weight's
  bool polished = false;     ///< the time is the method's own, not only its path's

  auto order() const { return std::tuple(time, weight, other, kind); }
};

/// Upcoming events, earliest first; ties by weight, so that runs are repeatable to the bit.
/// Entries whose weight has got another piece since are stale: whoever pops them skips them.
class EventQueue {
 public:
  void push(const Upcoming& event) {
    m_heap.push_back(event);
    std::ranges::push_heap(m_heap, isLater);
  }
  bool isEmpty() const { return m_heap.empty(); }
  /// @pre not isEmpty()
  const Upcoming& first() const { return m_heap.front(); }
  /// Keeps the memory for the next step.
  void clear() { m_heap.clear(); }

  Upcoming pop() {
    std::ranges::pop_heap(m_heap, isLater);
    const Upcoming first = m_heap.back();
    m_heap.pop_back();
    return first;
  }

 private:
  static bool isLater(const Upcoming& a, const Upcoming& b) { return a.order() > b.order(); }

  std::vector<Upcoming> m_heap;
};

}  // namespace core
