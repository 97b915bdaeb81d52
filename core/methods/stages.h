#pragma once

#include <array>

namespace core {

/// The slopes a method took on its way through one step, for the step panel to show.
template <class State, int kCount>
struct Stages {
  std::array<State, kCount> slopes;  ///< dx/dt at each stage, SI units per second
  State end;                         ///< state after the step
};

}  // namespace core
