#pragma once

#include <cstdint>
#include <vector>

#include "core/run/adaptive_stepper.h"
#include "core/run/event.h"
#include "core/run/piece.h"

namespace core {

/// What changes about one weight.
struct WeightRecord {
  Entries state = Entries::Zero();
  Mode mode = Mode::kFlight;
  bool tied = false;     ///< to a rope or rod, taut or slack
  bool settled = false;  ///< one of a group in lasting contact
  bool asleep = false;   ///< settled, and nothing in its group moves
  double stillFor = 0;   ///< how long it has hardly moved [s]
};

/// Energy that left the weights other than through the air [J].
struct Losses {
  double impacts = 0;
  double ropes = 0;
  double friction = 0;
};

/// Impulses a lasting contact needed the last time, where the next search for them begins.
struct CarriedContact {
  int a;        ///< weight
  int b;        ///< other weight, or a surface below 0
  double push;  ///< [N s]
  double drag;  ///< [N s]
};

/// How far a run has come, but for its weights.
struct Progress {
  std::int64_t stepCount = 0;
  std::int64_t evaluations = 0;
  Losses losses;
  bool cutTimePassed = false;
  std::vector<CarriedContact> contacts;  ///< in order of (a, b)
  std::vector<Pace> paces;               ///< of the weights; empty unless the method is adaptive
  std::vector<Event> pending;            ///< cuts by hand, to be listed with the coming step
};

/// Everything that decides how a run goes on, between two steps.
struct EngineState : Progress {
  Progress& progress() { return *this; }
  const Progress& progress() const { return *this; }

  std::vector<WeightRecord> weights;
};

}  // namespace core
