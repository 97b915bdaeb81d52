#pragma once

#include <array>

#include <Eigen/Core>

namespace core {

/// State of one weight (kLanes = 1) or of a batch of weights side by side: one row per
/// weight, one column per entry, so that each entry of a batch is one vector register wide.
template <int kEntries, int kLanes = 1>
using StateArray =
    Eigen::Array<double, kLanes, kEntries, kLanes == 1 ? Eigen::RowMajor : Eigen::ColMajor>;

/// One number per weight of a batch.
template <int kLanes>
using Lanes = Eigen::Array<double, kLanes, 1>;

/// How many places a state holds. They come first, then as many rates in the same order, then
/// the energy lost to air.
template <class State>
inline constexpr int kPlaces = (State::ColsAtCompileTime - 1) / 2;

/// Entries (θ [rad], ω [rad/s], Q [J]); Q is the energy lost to air so far.
template <int kLanes = 1>
using SwingState = StateArray<3, kLanes>;

/// Entries (x [m], y [m], v_x [m/s], v_y [m/s], Q [J]).
template <int kLanes = 1>
using FlightState = StateArray<5, kLanes>;

/// Entries (x [m], v [m/s], Q [J]) along a surface.
template <int kLanes = 1>
using SlideState = StateArray<3, kLanes>;

}  // namespace core
