#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "core/scene/scene.h"

namespace tests {

/// What bytes say is to be done: a scene that can run, how it is solved, and what is done to it
/// on its way.
struct FuzzedRun {
  std::shared_ptr<const core::Scene> scene;
  core::Solver solver;
  bool isOrdinary = false;  ///< weights, room and speeds as in a classroom: with tighter bounds
  int cutAllBefore = -1;    ///< the step before which all ropes are cut by hand, or −1
  int cutOneBefore = -1;    ///< likewise for the first weight's alone
  int resumedAt = -1;       ///< the step whose state another run goes on from, or −1
};

/// Any bytes, of any number, make a run; few bytes make a small one.
FuzzedRun fuzzedRun(std::span<const std::uint8_t> bytes);

/// Simulates 2 s, or kMostFuzzedSteps steps, and looks after each whether the run keeps what
/// every run must; and whether a run that goes on from one of its states takes the same way.
///
/// A run that ends with a status that says why is sound, and so is one at the ends of the ranges
/// that has more work than anybody waits for: that is given up, as the window does.
/// @return  what is wrong, in words; empty if nothing is
std::string faultIn(const FuzzedRun& fuzzed);

inline constexpr int kMostFuzzedSteps = 240;
inline constexpr int kMostFuzzedWeights = 8;

}  // namespace tests
