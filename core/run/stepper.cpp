#include "core/run/stepper.h"

#include <cmath>

#include "core/methods/method_list.h"
#include "core/motion/flight.h"
#include "core/motion/slide.h"
#include "core/motion/swing.h"
#include "core/run/path_end.h"

namespace core {
namespace {

/// θ, ω, Q of a swing or x, v, Q of a slide: three of the five entries.
SwingState<> threeOf(const Entries& entries) {
  return {entries[0], entries[2], entries[4]};
}

Entries fiveOf(const SwingState<>& three, double secondPlace) {
  return {three[0], secondPlace, three[1], 0, three[2]};
}

bool isStill(Mode mode, const Entries& state) {
  return mode == Mode::kHeld || (mode == Mode::kSlide && state[2] == 0);
}

}  // namespace

Stepper::Stepper(const Method& method, double gravity, double friction)
    : m_method(&method),
      m_index(static_cast<std::size_t>(&method - methods().data())),
      m_gravity(gravity),
      m_friction(friction * gravity) {}

bool Stepper::isStill(const Piece& piece) {
  if (piece.settled) return (piece.beginState.segment<2>(2) == 0).all();
  return core::isStill(piece.mode, piece.beginState);
}

Entries Stepper::slope(const Body& body, Mode mode, const Entries& state) {
  Piece piece;
  piece.mode = mode;
  piece.beginState = state;
  return slopeOn(body, piece, state);
}

Entries Stepper::slopeOn(const Body& body, const Piece& piece, const Entries& state) {
  if (core::isStill(piece.mode, piece.beginState)) return Entries::Zero();
  ++m_evaluations;
  switch (piece.mode) {
    case Mode::kSwing:
    case Mode::kHeld:
      return fiveOf(Swing<>(m_gravity, body.length, body.mass, body.drag)(threeOf(state)), 0);
    case Mode::kSlide: {
      const double way = std::copysign(1, piece.beginState[2]);
      return fiveOf(Slide(m_friction, way, body.mass, body.drag)(threeOf(state)), 0);
    }
    case Mode::kFlight:
      break;
  }
  return Flight<>(m_gravity, body.mass, body.drag)(state);
}

void Stepper::fill(const Body& body, Piece& piece) {
  if (piece.settled) return fillSettled(body, piece);
  piece.straight = m_method->path == PathShape::kStraight;
  piece.beginSlope = slope(body, piece.mode, piece.beginState);
  piece.endState = step(body, piece, piece.end - piece.begin);
  piece.endSlope = pathEndSlope(body, piece);
}

Entries Stepper::pathEndSlope(const Body& body, const Piece& piece) {
  return core::pathEndSlope(
      m_method->path, [&](const Entries& state) { return slopeOn(body, piece, state); },
      piece.beginState, piece.endState, piece.beginSlope, piece.end - piece.begin);
}

void Stepper::fillSettled(const Body& body, Piece& piece) {
  const Eigen::Vector2d velocity = velocityOf(body, piece.mode, piece.beginState);
  const double speed = velocity.norm();
  piece.straight = true;
  piece.beginSlope << piece.beginState[2], piece.beginState[3], 0, 0,
      body.mass * body.drag * speed * speed * speed;
  piece.endState = piece.beginState + (piece.end - piece.begin) * piece.beginSlope;
  piece.endSlope = piece.beginSlope;
}

Entries Stepper::partial(const Body& body, const Piece& piece, double s) {
  if (s <= piece.begin) return piece.beginState;
  if (piece.settled) return piece.at(s);
  return step(body, piece, s - piece.begin);
}

Entries Stepper::step(const Body& body, const Piece& piece, double duration) {
  if (isStill(piece)) return piece.beginState;
  m_evaluations += m_method->slopesPerStep - 1;
  Entries end;
  withMethod(m_index, [&](auto unit) {
    using Unit = decltype(unit);
    switch (piece.mode) {
      case Mode::kSwing:
      case Mode::kHeld: {
        const Swing<> swing(m_gravity, body.length, body.mass, body.drag);
        end = fiveOf(
            Unit::step(swing, threeOf(piece.beginState), threeOf(piece.beginSlope), duration).end,
            0);
        return;
      }
      case Mode::kSlide: {
        const Slide slide(m_friction, std::copysign(1, piece.beginState[2]), body.mass, body.drag);
        end = fiveOf(
            Unit::step(slide, threeOf(piece.beginState), threeOf(piece.beginSlope), duration).end,
            piece.beginState[1]);
        return;
      }
      case Mode::kFlight: {
        const Flight<> flight(m_gravity, body.mass, body.drag);
        end = Unit::step(flight, piece.beginState, piece.beginSlope, duration).end;
        return;
      }
    }
  });
  return end;
}

}  // namespace core
