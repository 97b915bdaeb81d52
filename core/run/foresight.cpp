#include "core/run/foresight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace core {
namespace {

// A rope's path is cut into arcs whose plane cubics are off by this share of the rope's length:
// where it turns steadily, into arcs of 0.12 rad. Long ropes' are off by no more than those of 1 m.
constexpr double kArcShare = 5.4e-7;
constexpr double kLongRope = 1;  // [m]
// Squares of distances on a way longer than this many times the distance that counts are rounded to
// more than a hundred millionth of it.
constexpr double kLongWay = 1e4;
// A flight with less sideways speed than this share of its change of vertical speed counts
// as straight up.
constexpr double kSteep = 0.05;
// What rounding leaves of sums that cancel, as a share of what is added up.
constexpr double kRounding = 1e-12;
// An entry that may be zero, until they are this close in shares of its size.
constexpr double kCloseShare = 1e-6;

Bernstein<3> negated(Bernstein<3> b) {
  for (double& coefficient : b) coefficient = -coefficient;
  return b;
}

/// First place in [0, 1] where the sign changes; a start at zero is not a change.
std::optional<double> signChange(const Bernstein<3>& b) {
  if (b[0] != 0) return firstFall<3>(b[0] > 0 ? b : negated(b), 0);
  const Bernstein<2> rest = withoutRootAtZero<3>(b);
  if (rest[0] == 0) return std::nullopt;
  Bernstein<2> oriented = rest;
  if (rest[0] < 0)
    for (double& coefficient : oriented) coefficient = -coefficient;
  return firstFall<2>(oriented, 0);
}

/// First place in [0, 1] where the value falls below zero; one that starts at zero falls there
/// only if it goes down.
std::optional<double> fallBelowZero(const Bernstein<3>& b) {
  if (b[0] != 0) return firstFall<3>(b, 0);
  const Bernstein<2> rest = withoutRootAtZero<3>(b);
  return rest[0] == 0 ? std::nullopt : firstFall<2>(rest, 0);
}

/// Where on [from, to] the place u lies.
std::optional<double> momentOf(std::optional<double> u, double from, double to) {
  if (!u) return std::nullopt;
  return from + *u * (to - from);
}

/// The way of a as b sees it.
Path relative(Path a, const Path& b) {
  for (std::size_t i = 0; i < a.points.size(); ++i) a.points[i] -= b.points[i];
  a.velocity -= b.velocity;
  return a;
}

/// Whether the way is too long to be asked where it comes so near.
bool isLong(const Path& way, double distance) {
  const Box box = boxAround(way, 0);
  return (box.high - box.low).maxCoeff() > kLongWay * distance;
}

/// First moment in [from, to] where the entry's sign changes.
/// @param isZero  the entry is zero at `from`, whatever rounding makes of it
std::optional<double> signChangeWithin(const Piece& piece, int index, double from, double to,
                                       bool isZero = false) {
  Bernstein<3> cubic = piece.entry(index, from, to);
  if (isZero) cubic[0] = 0;
  const double bend = piece.bend(from, to)[index];
  const auto [low, high] = std::ranges::minmax(cubic);
  const double middle = 0.5 * (from + to);
  if (bend > kCloseShare * std::max(-low, high) && from < middle && middle < to) {
    if (low > bend || high < -bend) return std::nullopt;
    const std::optional<double> early = signChangeWithin(piece, index, from, middle, isZero);
    return early ? early : signChangeWithin(piece, index, middle, to);
  }
  return momentOf(signChange(cubic), from, to);
}

}  // namespace

bool Foresight::isCoarse(const Body& body, const Piece& piece, double from, double to) const {
  if (!piece.polynomial && !isTethered(piece.mode)) return false;
  const double allowed =
      piece.polynomial ? m_closeness : kArcShare * std::min(body.length, kLongRope);
  return departure(body, piece, from, to) > allowed;
}

/// Two taut ropes on one pivot whose lengths keep the weights apart at any angles.
bool Foresight::ropesKeepApart(const Body& a, const Piece& pieceA, const Body& b,
                               const Piece& pieceB) const {
  return isTethered(pieceA.mode) && isTethered(pieceB.mode) && a.pivot == b.pivot &&
         std::abs(a.length - b.length) > a.radius + b.radius + m_tolerance.gap;
}

std::optional<Foresight::Moment> Foresight::meeting(const Body& a, const Piece& pieceA,
                                                    const Body& b, const Piece& pieceB) const {
  if (ropesKeepApart(a, pieceA, b, pieceB)) return std::nullopt;
  return meetingBetween(a, pieceA, b, pieceB, std::max(pieceA.begin, pieceB.begin),
                        std::min(pieceA.end, pieceB.end));
}

std::optional<Foresight::Moment> Foresight::meetingBetween(const Body& a, const Piece& pieceA,
                                                           const Body& b, const Piece& pieceB,
                                                           double from, double to) const {
  if (!boxOf(a, pieceA, from, to).meets(boxOf(b, pieceB, from, to))) return std::nullopt;
  if (!isCoarse(a, pieceA, from, to) && !isCoarse(b, pieceB, from, to)) {
    const double touching = a.radius + b.radius;
    const Path pathA = pathOf(a, pieceA, from, to), pathB = pathOf(b, pieceB, from, to);
    if (!isLong(relative(pathA, pathB), touching)) {
      const std::optional<Contact> contact =
          firstContact(pathA, pathB, touching, to - from, m_tolerance);
      if (!contact) return std::nullopt;
      return Moment{from + contact->u * (to - from), contact->pressing};
    }
  }
  const double middle = 0.5 * (from + to);
  if (middle <= from || middle >= to) return std::nullopt;
  const std::optional<Moment> early = meetingBetween(a, pieceA, b, pieceB, from, middle);
  return early ? early : meetingBetween(a, pieceA, b, pieceB, middle, to);
}

std::optional<Foresight::WallMoment> Foresight::wall(const Body& body, const Piece& piece,
                                                     const Box& box) const {
  if (piece.mode == Mode::kHeld || isInside(box)) return std::nullopt;
  return wallBetween(body, piece, piece.begin, piece.end);
}

bool Foresight::isInside(const Box& box) const {
  return (box.low.array() > m_tolerance.gap).all() &&
         box.high.x() < m_room.width - m_tolerance.gap &&
         box.high.y() < m_room.height - m_tolerance.gap;
}

std::optional<Foresight::WallMoment> Foresight::wallBetween(const Body& body, const Piece& piece,
                                                            double from, double to) const {
  if (isInside(boxOf(body, piece, from, to))) return std::nullopt;
  if (isCoarse(body, piece, from, to)) {
    const double middle = 0.5 * (from + to);
    if (middle <= from || middle >= to) return std::nullopt;
    const std::optional<WallMoment> early = wallBetween(body, piece, from, middle);
    return early ? early : wallBetween(body, piece, middle, to);
  }
  const Path path = pathOf(body, piece, from, to);
  std::optional<WallMoment> first;
  const auto look = [&](int axis, double wall, double inward, Upcoming::Kind kind) {
    Bernstein<3> distance = path.coordinate(axis);
    for (double& d : distance) d = inward * (d - wall) - body.radius;
    const std::optional<Contact> contact =
        firstWallContact(distance, inward * path.velocity[axis], to - from, m_tolerance);
    if (!contact) return;
    const double time = from + contact->u * (to - from);
    if (!first || time < first->time) first = WallMoment{{time, contact->pressing}, kind};
  };
  if (piece.mode != Mode::kSlide) look(1, 0, 1, Upcoming::Kind::kFloor);
  look(1, m_room.height, -1, Upcoming::Kind::kCeiling);
  look(0, 0, 1, Upcoming::Kind::kWest);
  look(0, m_room.width, -1, Upcoming::Kind::kEast);
  return first;
}

std::optional<double> Foresight::turningPoint(const Piece& piece,
                                              std::optional<double> before) const {
  const double from = before.value_or(piece.begin);
  if (piece.mode != Mode::kSwing || from >= piece.end) return std::nullopt;
  return signChangeWithin(piece, 2, from, piece.end, before.has_value());
}

std::optional<double> Foresight::apex(const Piece& piece) const {
  if (piece.mode != Mode::kFlight) return std::nullopt;
  const double change = std::abs(piece.endState[3] - piece.beginState[3]);
  if (piece.beginState[3] <= 0 || std::abs(piece.beginState[2]) > kSteep * change)
    return std::nullopt;
  return signChangeWithin(piece, 3, piece.begin, piece.end);
}

double Foresight::tension(const Body& body, const Entries& state) const {
  return m_gravity * std::cos(state[0]) + body.length * state[2] * state[2];
}

std::optional<double> Foresight::slack(const Body& body, const Piece& piece) const {
  if (piece.mode != Mode::kSwing || body.rigid) return std::nullopt;
  return slackBetween(body, piece, piece.begin, piece.end);
}

std::optional<double> Foresight::slackBetween(const Body& body, const Piece& piece, double from,
                                              double to) const {
  // Below the pivot's height gravity alone keeps the rope taut.
  const double highest = std::abs(piece.at(from)[0]) + turnWithin(piece, from, to);
  if (highest < 0.5 * std::numbers::pi) return std::nullopt;
  // Nor does a rope go slack that turns fast enough for any angle.
  const auto [low, high] = std::ranges::minmax(piece.entry(2, from, to));
  const double slowest = std::max({0.0, low, -high}) - piece.bend(from, to)[2];
  if (slowest > 0 && body.length * slowest * slowest > m_gravity) return std::nullopt;
  const double middle = 0.5 * (from + to);
  if (isCoarse(body, piece, from, to) && from < middle && middle < to) {
    const std::optional<double> early = slackBetween(body, piece, from, middle);
    return early ? early : slackBetween(body, piece, middle, to);
  }
  const auto rate = [&](double s, const Entries& state) {
    const Entries slope = piece.rateAt(s);
    return -m_gravity * std::sin(state[0]) * slope[0] + 2 * body.length * state[2] * slope[2];
  };
  const Entries begin = piece.at(from), end = piece.at(to);
  const double third = (to - from) / 3;
  // A rope that has just gone taut without a pull: the rate decides. What counts as no pull here
  // counts so for taut() by all means, or a rope could go slack and taut without end.
  const double rounding = 0.5 * kRounding * (m_gravity + body.length * begin[2] * begin[2]);
  const bool isZero = from <= piece.begin && std::abs(tension(body, begin)) <= rounding;
  const double first = isZero ? 0 : tension(body, begin), last = tension(body, end);
  return momentOf(
      fallBelowZero({first, first + third * rate(from, begin), last - third * rate(to, end), last}),
      from, to);
}

std::optional<double> Foresight::taut(const Body& body, const Piece& piece) const {
  if (!piece.tied || isTethered(piece.mode)) return std::nullopt;
  const Eigen::Vector2d out = positionOf(body, piece.mode, piece.beginState) - body.pivot;
  const Eigen::Vector2d radial = out.normalized();
  const Eigen::Vector2d velocity = velocityOf(body, piece.mode, piece.beginState);
  Eigen::Vector2d acceleration = piece.beginSlope.segment<2>(2).transpose();
  // That method's places fall twice as fast within a step: v s + a s².
  if (m_shape == PathShape::kParabola) acceleration *= 2;
  const double around = velocity.x() * radial.y() - velocity.y() * radial.x();
  const double centripetal = around * around / body.length;
  const double outward = centripetal + acceleration.dot(radial);
  // Where the tension falls to zero the two cancel, up to rounding.
  const double rounding = kRounding * (m_gravity + acceleration.norm() + centripetal);
  const bool pulled = outward > rounding;
  // A straight path cannot follow a circle it starts along: Euler's own error takes it
  // outside by the sagitta of what it moves in a step or two, and gravity bends it back.
  const double stretch = out.norm() - body.length;
  const double travel = velocity.norm() * (piece.end - piece.begin);
  const bool isAlong = velocity.dot(radial) <= 2 * velocity.norm() * travel / body.length;
  if (piece.straight && !pulled && isAlong && stretch >= -m_tolerance.gap &&
      stretch < travel * travel / body.length)
    return std::nullopt;
  return tautBetween(body, piece, piece.begin, piece.end,
                     std::abs(outward) > rounding ? outward : 0);
}

std::optional<double> Foresight::tautBetween(const Body& body, const Piece& piece, double from,
                                             double to, double outward) const {
  const double middle = 0.5 * (from + to);
  const Path path = pathOf(body, piece, from, to);
  const bool isTooMuch = isLong(path, body.length) || isCoarse(body, piece, from, to);
  if (isTooMuch && from < middle && middle < to) {
    const Box box = boxOf(body, piece, from, to);
    const Eigen::Vector2d farthest =
        (box.high - body.pivot).cwiseAbs().cwiseMax((box.low - body.pivot).cwiseAbs());
    if (farthest.norm() < body.length) return std::nullopt;
    const std::optional<double> early = tautBetween(body, piece, from, middle, outward);
    return early ? early : tautBetween(body, piece, middle, to, 0);
  }
  return momentOf(firstTaut(path, body.pivot, body.length, to - from, outward, m_tolerance), from,
                  to);
}

std::optional<double> Foresight::stop(const Piece& piece) const {
  if (piece.mode != Mode::kSlide || piece.beginState[2] == 0) return std::nullopt;
  return signChangeWithin(piece, 2, piece.begin, piece.end);
}

}  // namespace core
