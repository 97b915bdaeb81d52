#include "core/run/piece.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

/// By how much a point that goes around the unit circle, at an angle θ that is this cubic, departs
/// at most from the plane cubic with its places and velocities at both ends: 1/384 of a bound of
/// the fourth derivative of (sin θ, −cos θ), θ'⁴ + 6 θ'² θ'' + 3 θ''² + 4 θ' θ'''.
double circleDeparture(const Bernstein<3>& angle) {
  const double d1 = angle[1] - angle[0], d2 = angle[2] - angle[1], d3 = angle[3] - angle[2];
  const double first = 3 * std::max({std::abs(d1), std::abs(d2), std::abs(d3)});
  const double second = 6 * std::max(std::abs(d2 - d1), std::abs(d3 - d2));
  const double third = 6 * std::abs(d3 - 2 * d2 + d1);
  const double square = first * first;
  return (square * square + 6 * square * second + 3 * second * second + 4 * first * third) / 384;
}

}  // namespace

Entries flightEntries(const Eigen::Vector2d& position, const Eigen::Vector2d& velocity,
                      double lostToAir) {
  Entries entries;
  entries << position.x(), position.y(), velocity.x(), velocity.y(), lostToAir;
  return entries;
}

Entries Piece::at(double s) const {
  const double duration = end - begin;
  const double elapsed = s - begin;
  if (elapsed >= duration) return endState;
  if (elapsed <= 0) return beginState;
  if (straight) return beginState + elapsed * beginSlope;
  // What air took is never given back, but the path of a step far too large swings below it.
  if (polynomial) {
    Entries state = polynomial->at(elapsed);
    state[4] = std::max(beginState[4], state[4]);
    return state;
  }
  const double u = elapsed / duration;
  Entries state = beginState + u * u * (3 - 2 * u) * (endState - beginState) +
                  elapsed * (1 - u) * ((1 - u) * beginSlope - u * endSlope);
  state[4] = std::max(beginState[4], std::min(state[4], endState[4]));
  return state;
}

Entries Piece::rateAt(double s) const {
  const double duration = end - begin;
  if (straight || s <= begin || duration <= 0) return beginSlope;
  if (polynomial) return polynomial->rateAt(std::min(s - begin, duration));
  if (s >= end) return endSlope;
  const double u = (s - begin) / duration;
  return 6 * u * (1 - u) / duration * (endState - beginState) + (1 - u) * (1 - 3 * u) * beginSlope +
         u * (3 * u - 2) * endSlope;
}

Bernstein<3> Piece::entry(int index, double from, double to) const {
  const double third = (to - from) / 3;
  const double first = at(from)[index], last = at(to)[index];
  return {first, first + third * rateAt(from)[index], last - third * rateAt(to)[index], last};
}

Entries Piece::bend(double from, double to) const {
  return polynomial ? polynomial->bend(to - from) : Entries::Zero();
}

Eigen::Vector2d positionOf(const Body& body, Mode mode, const Entries& state) {
  if (!isTethered(mode)) return {state[0], state[1]};
  return body.pivot + body.length * Eigen::Vector2d(std::sin(state[0]), -std::cos(state[0]));
}

Eigen::Vector2d velocityOf(const Body& body, Mode mode, const Entries& state) {
  if (!isTethered(mode)) return {state[2], state[3]};
  return body.length * state[2] * trackOf(state);
}

Eigen::Vector2d trackOf(const Entries& state) {
  return {std::cos(state[0]), std::sin(state[0])};
}

double turnWithin(const Piece& piece, double from, double to) {
  if (piece.mode != Mode::kSwing) return 0;
  const double duration = to - from;
  const double begin = piece.at(from)[0], end = piece.at(to)[0];
  if (piece.straight) return std::abs(end - begin);
  const double second = begin + duration / 3 * piece.rateAt(from)[0];
  const double third = end - duration / 3 * piece.rateAt(to)[0];
  return std::abs(second - begin) + std::abs(third - second) + std::abs(end - third) +
         piece.bend(from, to)[0];
}

double departure(const Body& body, const Piece& piece, double from, double to) {
  const Entries bend = piece.bend(from, to);
  if (!isTethered(piece.mode)) return std::hypot(bend[0], bend[1]);
  return body.length * (bend[0] + circleDeparture(piece.entry(0, from, to)));
}

Path pathOf(const Body& body, const Piece& piece, double from, double to) {
  const Entries begin = piece.at(from), end = piece.at(to);
  Entries beginMoving = begin, endMoving = end;
  beginMoving.segment<2>(2) = piece.rateAt(from).segment<2>(0);
  endMoving.segment<2>(2) = piece.rateAt(to).segment<2>(0);
  if (isTethered(piece.mode)) {
    beginMoving[2] = piece.rateAt(from)[0];
    endMoving[2] = piece.rateAt(to)[0];
  }
  return Path::through(positionOf(body, piece.mode, begin),
                       velocityOf(body, piece.mode, beginMoving), positionOf(body, piece.mode, end),
                       velocityOf(body, piece.mode, endMoving), to - from);
}

Box boxOf(const Body& body, const Piece& piece, double from, double to) {
  if (!isTethered(piece.mode))
    return boxAround(pathOf(body, piece, from, to), body.radius + departure(body, piece, from, to));
  // Every place on the arc is within the arc's length of its start, and on the circle.
  const Eigen::Vector2d start = positionOf(body, piece.mode, piece.at(from));
  const double reach = body.length * turnWithin(piece, from, to);
  const Eigen::Vector2d disc(body.radius, body.radius);
  const Eigen::Vector2d arc = disc + Eigen::Vector2d(reach, reach);
  const Eigen::Vector2d circle = disc + Eigen::Vector2d(body.length, body.length);
  return {(start - arc).cwiseMax(body.pivot - circle), (start + arc).cwiseMin(body.pivot + circle)};
}

}  // namespace core
