#pragma once

#include <array>
#include <cmath>

#include "core/motion/flight.h"
#include "core/motion/slide.h"
#include "core/motion/swing.h"
#include "core/run/piece.h"

namespace core {

/// A swing's or a slide's state among the five entries: place, rate, energy.
struct TrackForm {
  static SwingState<> from(const Entries& entries) { return {entries[0], entries[2], entries[4]}; }
  /// @param across  the place that stays
  static Entries entries(const SwingState<>& state, double across) {
    return {state[0], across, state[1], 0, state[2]};
  }
  static std::array<Series, 5> series(const std::array<Series, 3>& own, double across) {
    return {own[0], Series{across}, own[1], Series{}, own[2]};
  }
};

/// A flight's state: the entries themselves.
struct FlightForm {
  static const Entries& from(const Entries& entries) { return entries; }
  static const Entries& entries(const FlightState<>& state, double /*across*/) { return state; }
  static const std::array<Series, 5>& series(const std::array<Series, 5>& own, double /*across*/) {
    return own;
  }
};

/// Calls `use` with the equations that move the weight on a piece whose mode and beginState
/// are set, and with the form of their state. A slide goes on the way it starts.
///
/// @param friction  μ g [m/s²]
/// @return          what `use` returns
template <class Use>
auto withEquations(const Body& body, const Piece& piece, double gravity, double friction,
                   const Use& use) {
  switch (piece.mode) {
    case Mode::kSwing:
    case Mode::kHeld:
      return use(Swing<>(gravity, body.length, body.mass, body.drag), TrackForm{});
    case Mode::kSlide:
      return use(Slide(friction, std::copysign(1, piece.beginState[2]), body.mass, body.drag),
                 TrackForm{});
    case Mode::kFlight:
      break;
  }
  return use(Flight<>(gravity, body.mass, body.drag), FlightForm{});
}

}  // namespace core
