#pragma once

#include <Eigen/Core>

#include "core/motion/lanes.h"

namespace core {

/// State of one weight (Number = double) or of a batch of weights side by side
/// (Number = Lanes, so that each entry of a batch is a vector register or a few).
template <int kEntries, class Number = double>
using StateArray = Eigen::Array<Number, 1, kEntries>;

/// One weight's state out of a batch.
template <int kEntries>
StateArray<kEntries> laneOf(const StateArray<kEntries, Lanes>& batch, int lane) {
  StateArray<kEntries> state;
  for (int i = 0; i < kEntries; ++i) state[i] = batch[i][lane];
  return state;
}

/// Puts one weight's state into a batch.
template <int kEntries>
void setLane(StateArray<kEntries, Lanes>& batch, int lane, const StateArray<kEntries>& state) {
  for (int i = 0; i < kEntries; ++i) batch[i].set(lane, state[i]);
}

/// How many places a state holds. They come first, then as many rates in the same order, then
/// the energy lost to air.
template <class State>
inline constexpr int kPlaces = (State::ColsAtCompileTime - 1) / 2;

/// Entries (θ [rad], ω [rad/s], Q [J]); Q is the energy lost to air so far.
template <class Number = double>
using SwingState = StateArray<3, Number>;

/// Entries (x [m], y [m], v_x [m/s], v_y [m/s], Q [J]).
template <class Number = double>
using FlightState = StateArray<5, Number>;

/// Entries (x [m], v [m/s], Q [J]) along a surface.
template <class Number = double>
using SlideState = StateArray<3, Number>;

}  // namespace core
