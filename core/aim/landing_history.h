#pragma once

#include <cstdint>
#include <vector>

#include "core/aim/landing.h"
#include "core/run/event.h"

namespace core {

/// Whether places may jump with it: something was hit, a rope pulled tight, or ropes were cut.
bool mayMatter(const Event& event);

/// What happened in a scene up to the landing of one weight.
class LandingHistory {
 public:
  explicit LandingHistory(int weight) : m_weight(weight) {}

  /// Takes the next event of the run.
  void add(const Event& event);

  /// All ropes are cut.
  bool isCut() const { return m_isCut; }
  /// The latest event brought the weight to the floor after the cut.
  bool isLanding(const Event& event) const;
  FirstHit firstHit() const { return m_firstHit; }

  /// A number that stands for all events that can have mattered: those of the weight, those of
  /// weights that it was hit by until then, and so on back in time, and for their order around
  /// the cut. What else happened in the room does not change it.
  std::uint64_t mark() const;

 private:
  int m_weight;
  bool m_isCut = false;
  FirstHit m_firstHit = FirstHit::kNothing;
  std::vector<Event> m_events;
};

}  // namespace core
