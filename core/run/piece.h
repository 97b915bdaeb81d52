#pragma once

#include <cstdint>
#include <memory>

#include <Eigen/Core>

#include "core/contact/bernstein.h"
#include "core/contact/path.h"
#include "core/motion/state.h"
#include "core/run/body.h"
#include "core/run/polynomial.h"

namespace core {

/// Which equations move a weight.
enum class Mode : std::uint8_t {
  kSwing,   ///< on a taut rope or a rod
  kHeld,    ///< on a taut rope or a rod, pressed against a wall
  kFlight,  ///< flies free, or inside the circle of its slack rope
  kSlide,   ///< lies on the floor, and may slide
};

inline bool isTethered(Mode mode) {
  return mode == Mode::kSwing || mode == Mode::kHeld;
}

/// State of a weight in one shape for all modes: place, place, rate, rate, energy lost to air.
///     kSwing, kHeld     θ [rad], 0, ω [rad/s], 0, Q [J]
///     kFlight           x [m], y [m], v_x [m/s], v_y [m/s], Q [J]
///     kSlide            x [m], y [m], v_x [m/s], 0, Q [J]
using Entries = FlightState<>;

/// The entries of a weight in flight: center [m], velocity [m/s], energy lost to air [J].
Entries flightEntries(const Eigen::Vector2d& position, const Eigen::Vector2d& velocity,
                      double lostToAir);

/// A weight between two events of one step, or the whole step if there are none. Times
/// count from the start of the step.
struct Piece {
  double begin = 0;  ///< [s]
  double end = 0;    ///< [s]
  Mode mode = Mode::kFlight;
  bool tied = false;     ///< to a rope or rod, taut or slack
  bool settled = false;  ///< one of a group in lasting contact: moves evenly, see engine_resting
  bool straight =
      false;  ///< every entry changes evenly; else Hermite's cubic, or a parabola as one
  Entries beginState = Entries::Zero();
  Entries endState = Entries::Zero();
  Entries beginSlope = Entries::Zero();  ///< d(state)/dt
  Entries endSlope = Entries::Zero();
  /// The path of methods that know more than the cubic; from begin on, to end or beyond.
  std::shared_ptr<const Polynomial> polynomial = nullptr;

  /// State on the path at s in [begin, end].
  Entries at(double s) const;
  /// d/ds of the path at s: the rate of change of places the path shows, which for Euler's
  /// straight paths is not the velocity entry.
  Entries rateAt(double s) const;
  /// One entry over a part of the piece as a cubic.
  Bernstein<3> entry(int index, double from, double to) const;
  /// By how much the entries depart at most from their cubics over that part; zero where the
  /// path is a cubic.
  Entries bend(double from, double to) const;
};

/// Center of the weight in that state [m].
Eigen::Vector2d positionOf(const Body& body, Mode mode, const Entries& state);
/// Velocity of the center in that state [m/s].
Eigen::Vector2d velocityOf(const Body& body, Mode mode, const Entries& state);
/// Direction a weight on a taut rope can move in: (cos θ, sin θ).
Eigen::Vector2d trackOf(const Entries& state);

/// By how much the center departs at most from pathOf() between two moments of the piece [m].
double departure(const Body& body, const Piece& piece, double from, double to);

/// How far the rope turns at most between two moments of the piece [rad], ≥ 0; 0 unless it
/// is taut.
double turnWithin(const Piece& piece, double from, double to);

/// The center's path between two moments of the piece, as a cubic in the plane. Exact for
/// weights in flight; on a rope that turns by φ it is off by at most L φ⁴/384, and exact at
/// both ends.
Path pathOf(const Body& body, const Piece& piece, double from, double to);

/// A box that holds the disc between two moments of the piece, at any turn.
Box boxOf(const Body& body, const Piece& piece, double from, double to);

}  // namespace core
