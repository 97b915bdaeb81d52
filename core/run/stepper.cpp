#include "core/run/stepper.h"

#include <algorithm>
#include <cmath>

#include "core/run/path_end.h"

namespace core {
namespace {

// A step that ends further than this from the path to the end of a longer one [m]: that one is too
// long for either to tell where the weight goes, but along the path nothing stands.
constexpr double kAstray = 2e-7;

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
  return withMotion(body, piece, [&](const auto& motion, auto form) -> Entries {
    return form.entries(motion(form.from(state)), 0);
  });
}

void Stepper::fill(const Body& body, Piece& piece) {
  if (piece.settled) return fillSettled(piece);
  piece.straight = m_method->path == PathShape::kStraight;
  piece.beginSlope = slope(body, piece.mode, piece.beginState);
  piece.endState = step(body, piece, piece.end - piece.begin);
  piece.endSlope = pathEndSlope(body, piece);
}

Entries Stepper::pathEndSlope(const Body& body, const Piece& piece) {
  if (m_method->path == PathShape::kPolynomial) return piece.rateAt(piece.end);
  return core::pathEndSlope(
      m_method->path, [&](const Entries& state) { return slopeOn(body, piece, state); },
      piece.beginState, piece.endState, piece.beginSlope, piece.end - piece.begin);
}

void Stepper::fillSettled(Piece& piece) {
  // What air takes is taken where forces are found.
  piece.straight = true;
  piece.beginSlope << piece.beginState[2], piece.beginState[3], 0, 0, 0;
  piece.endState = piece.beginState + (piece.end - piece.begin) * piece.beginSlope;
  piece.endSlope = piece.beginSlope;
}

Entries Stepper::partial(const Body& body, const Piece& piece, double s) {
  if (s <= piece.begin) return piece.beginState;
  if (piece.settled || m_method->path == PathShape::kPolynomial) return piece.at(s);
  Entries own = step(body, piece, s - piece.begin);
  if (m_method->path == PathShape::kStraight || m_method->path == PathShape::kParabola) return own;
  const Entries path = piece.at(s);
  const double length = isTethered(piece.mode) ? body.length : 1;
  return length * (own - path).abs().head<2>().maxCoeff() <= kAstray ? own : path;
}

std::vector<Stage> Stepper::stages(const Body& body, const Piece& piece) {
  std::vector<Stage> stages;
  if (piece.settled || isStill(piece) || m_method->path == PathShape::kPolynomial) return stages;
  const auto noted = [&](const Entries& state) {
    stages.push_back({.state = state, .slope = slopeOn(body, piece, state)});
    return stages.back().slope;
  };
  withMethod(m_index, [&](auto unit) {
    unit.step(noted, piece.beginState, noted(piece.beginState), piece.end - piece.begin);
  });
  return stages;
}

Entries Stepper::step(const Body& body, const Piece& piece, double duration) {
  if (isStill(piece)) return piece.beginState;
  m_evaluations += m_method->slopesPerStep - 1;
  Entries end = piece.beginState;
  withUnit([&](auto unit) {
    withMotion(body, piece, [&](const auto& motion, auto form) {
      const auto stages =
          unit.step(motion, form.from(piece.beginState), form.from(piece.beginSlope), duration);
      end = form.entries(stages.end, piece.beginState[1]);
    });
  });
  // What air took is never given back: where the error in that is the larger, it took nothing.
  end[4] = std::max(end[4], piece.beginState[4]);
  return end;
}

}  // namespace core
