#pragma once

#include <vector>

#include "core/recording/recording.h"
#include "core/run/event.h"

namespace tests {

inline bool isImpact(const core::Event& event) {
  return event.kind >= core::EventKind::kImpactFloor &&
         event.kind <= core::EventKind::kImpactWeight;
}

/// Times of a run's events that are wanted, each moment once [s].
template <class Wanted>
std::vector<double> timesOf(const core::Recording& recording, const Wanted& wanted) {
  std::vector<double> times;
  for (const core::Event& event : recording.eventLog().events())
    if (wanted(event) && (times.empty() || event.time > times.back())) times.push_back(event.time);
  return times;
}

}  // namespace tests
