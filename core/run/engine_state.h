#pragma once

#include <cstdint>
#include <vector>

#include "core/run/event.h"
#include "core/run/piece.h"

namespace core {

/// What changes about one weight.
struct WeightRecord {
  Entries state = Entries::Zero();
  Mode mode = Mode::kFlight;
  bool tied = false;  ///< to a rope or rod, taut or slack
};

/// Energy that left the weights other than through the air [J].
struct Losses {
  double impacts = 0;
  double ropes = 0;
  double friction = 0;
};

/// Everything that decides how a run goes on, between two steps.
struct EngineState {
  std::int64_t stepCount = 0;
  std::int64_t evaluations = 0;
  Losses losses;
  bool cutTimePassed = false;
  std::vector<WeightRecord> weights;
  std::vector<Event> pending;  ///< cuts by hand, to be listed with the coming step
};

}  // namespace core
