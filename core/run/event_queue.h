#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include <queue>

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

  auto order() const { return std::tuple(time, weight, other, kind); }
};

/// Upcoming events, earliest first; ties by weight, so that runs are repeatable to the bit.
/// Entries whose weight has got another piece since are stale: whoever pops them skips them.
class EventQueue {
 public:
  void push(const Upcoming& event) { m_queue.push(event); }
  bool isEmpty() const { return m_queue.empty(); }
  void clear() { m_queue = {}; }

  Upcoming pop() {
    const Upcoming first = m_queue.top();
    m_queue.pop();
    return first;
  }

 private:
  struct IsLater {
    bool operator()(const Upcoming& a, const Upcoming& b) const { return a.order() > b.order(); }
  };
  std::priority_queue<Upcoming, std::vector<Upcoming>, IsLater> m_queue;
};

}  // namespace core
