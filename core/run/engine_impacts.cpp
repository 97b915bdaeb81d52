#include <algorithm>
#include <cmath>

#include "core/run/engine.h"

namespace core {
namespace {

struct WallSide {
  int axis;       // 0: x, 1: y
  double place;   // of the wall [m]
  double inward;  // +1 or −1
  EventKind kind;
};

WallSide sideOf(Upcoming::Kind kind, const Room& room) {
  switch (kind) {
    case Upcoming::Kind::kCeiling:
      return {1, room.height, -1, EventKind::kImpactCeiling};
    case Upcoming::Kind::kWest:
      return {0, 0, 1, EventKind::kImpactWest};
    case Upcoming::Kind::kEast:
      return {0, room.width, -1, EventKind::kImpactEast};
    default:
      return {1, 0, 1, EventKind::kImpactFloor};
  }
}

Eigen::Vector2d inwardOf(const WallSide& side) {
  return side.axis == 0 ? Eigen::Vector2d(side.inward, 0) : Eigen::Vector2d(0, side.inward);
}

/// A bounce that would rise by less than this share of the radius is the last one. An elastic one
/// goes on for ever, unless all of it counts as touching.
constexpr double kLastRise = 1e-6;
/// So is, for weights that do not only bounce elastically, the contact after this many within
/// 1/60 s or a step: between weights in a heap the series of bounces need not end.
constexpr int kMostMeetings = 64;
/// The same for a weight that meets one of a group: bounces off it that do not end until the
/// forces in the group are found anew would be fewer.
constexpr int kMostMeetingsWithGroup = 8;
/// So is one off a group that would be over within this share of the step.
constexpr double kLastDuration = 1e-7;

}  // namespace

void Engine::hitWall(const Upcoming& event) {
  const int i = event.weight;
  const Body& body = m_bodies[i];
  const Piece piece = m_moving[i].piece;
  const WallSide side = sideOf(event.kind, m_scene->room);
  const auto gap = [&](const Entries& state) {
    return side.inward * (positionOf(body, piece.mode, state)[side.axis] - side.place) -
           body.radius;
  };
  Entries before = piece.at(event.time);
  double s = event.time;
  if (s > piece.begin) {
    Entries moving = before;
    moving.segment<2>(2) = piece.rateAt(s).segment<2>(0);
    if (isTethered(piece.mode)) moving[2] = piece.rateAt(s)[0];
    const double rate = side.inward * velocityOf(body, piece.mode, moving)[side.axis];
    const auto exact = polished(event, piece.begin, piece.end, rate, polishTolerance(),
                                [&](double at) { return gap(m_stepper.partial(body, piece, at)); });
    if (exact) {
      s = *exact;
      if (mustWait(event, s)) return;
      before = m_stepper.partial(body, piece, s);
    }
  }
  if (isTethered(piece.mode)) return hitWallOnRope(i, s, before, event);
  before[side.axis] = side.place + side.inward * body.radius;
  hitWallInFlight(i, s, before, event);
}

void Engine::hitWallInFlight(int index, double s, const Entries& before, const Upcoming& event) {
  const Body& body = m_bodies[index];
  const Piece& piece = m_moving[index].piece;
  const WallSide side = sideOf(event.kind, m_scene->room);
  const bool isFloor = event.kind == Upcoming::Kind::kFloor;
  const double approach = -side.inward * before[2 + side.axis];
  Entries after = before;
  if (event.pressing || std::abs(approach) <= m_tolerance.speed) {
    after[2 + side.axis] = 0;
    return goOn(index, s, before, isFloor ? Mode::kSlide : piece.mode, after);
  }
  // Euler's straight path may reach a wall that the velocity at that moment leaves again.
  if (approach < 0) return goOn(index, s, before, piece.mode, before);
  const WallImpact impact = wallImpact(before.segment<2>(2).transpose(), body.mass, inwardOf(side),
                                       m_scene->room.restitution, m_scene->room.friction);
  after.segment<2>(2) = impact.velocity.transpose();
  const WeightState stateBefore = readOut(index, piece.mode, piece.tied, before);
  log(side.kind, s, index, stateBefore, readOut(index, piece.mode, piece.tied, after),
      impact.energyLost);
  const double speedAfter = m_scene->room.restitution * approach;
  if (!isFloor || !comesToRest(speedAfter, -m_scene->gravity, body.radius))
    return goOn(index, s, before,
                piece.mode == Mode::kSlide && isFloor ? Mode::kFlight : piece.mode, after);
  rest(index, s, before, after, Mode::kSlide, 3, speedAfter);
}

void Engine::hitWallOnRope(int index, double s, const Entries& before, const Upcoming& event) {
  const Body& body = m_bodies[index];
  const Piece& piece = m_moving[index].piece;
  const WallSide side = sideOf(event.kind, m_scene->room);
  const double along = trackOf(before)[side.axis] * side.inward;  // t·n
  const double approach = -body.length * before[2] * along;
  Entries after = before;
  if (event.pressing || std::abs(approach) <= m_tolerance.speed) {
    after[2] = 0;
    return goOn(index, s, before, Mode::kHeld, after);
  }
  if (approach < 0) return goOn(index, s, before, piece.mode, before);
  const double e = m_scene->room.restitution;
  after[2] = -e * before[2];
  const double speed = body.length * before[2];
  log(side.kind, s, index, readOut(index, piece.mode, true, before),
      readOut(index, piece.mode, true, after), 0.5 * body.mass * speed * speed * (1 - e) * (1 + e));
  const double inward = body.length * m_stepper.slope(body, Mode::kSwing, after)[2] * along;
  if (!comesToRest(e * approach, inward, body.radius))
    return goOn(index, s, before, Mode::kSwing, after);
  rest(index, s, before, after, Mode::kHeld, 2, body.length * after[2]);
}

void Engine::rest(int index, double s, const Entries& before, const Entries& bounced, Mode mode,
                  int rateEntry, double speed) {
  const Piece& piece = m_moving[index].piece;
  Entries after = bounced;
  after[rateEntry] = 0;
  log(EventKind::kRest, s, index, readOut(index, piece.mode, piece.tied, bounced),
      readOut(index, piece.mode, piece.tied, after), 0.5 * m_bodies[index].mass * speed * speed);
  goOn(index, s, before, mode, after);
}

bool Engine::comesToRest(double speedAfter, double inwardAcceleration, double radius) const {
  if (inwardAcceleration >= 0) return false;
  const double visible = m_scene->room.restitution < 1 ? kLastRise * radius : 0;
  return speedAfter * speedAfter < -2 * inwardAcceleration * std::max(visible, m_tolerance.gap);
}

CollidingWeight Engine::colliding(int index, Mode mode, const Entries& state) const {
  const Body& body = m_bodies[index];
  CollidingWeight weight{velocityOf(body, mode, state), body.mass};
  if (isTethered(mode)) weight.track = trackOf(state);
  return weight;
}

Entries Engine::pushed(int index, Mode mode, const Entries& state,
                       const Eigen::Vector2d& velocityChange) const {
  Entries after = state;
  if (isTethered(mode)) {
    after[2] += velocityChange.dot(trackOf(state)) / m_bodies[index].length;
  } else {
    after.segment<2>(2) += velocityChange.transpose().array();
  }
  return after;
}

Mode Engine::modeAfterPush(Mode mode, const Entries& after, bool settled) const {
  if (settled) return isTethered(mode) ? Mode::kSwing : Mode::kFlight;
  if (mode == Mode::kHeld) return Mode::kSwing;
  if (mode == Mode::kSlide && std::abs(after[3]) > m_tolerance.speed) return Mode::kFlight;
  return mode;
}

void Engine::meet(const Upcoming& event) {
  const int a = event.weight, b = event.other;
  const Piece pieceA = m_moving[a].piece, pieceB = m_moving[b].piece;
  const auto apart = [&](const Entries& stateA, const Entries& stateB) -> Eigen::Vector2d {
    return positionOf(m_bodies[b], pieceB.mode, stateB) -
           positionOf(m_bodies[a], pieceA.mode, stateA);
  };
  const double touching = m_bodies[a].radius + m_bodies[b].radius;
  const double low = std::max(pieceA.begin, pieceB.begin);
  double s = event.time;
  Entries beforeA = pieceA.at(s), beforeB = pieceB.at(s);
  const auto gap = [&](double at) {
    return apart(m_stepper.partial(m_bodies[a], pieceA, at),
                 m_stepper.partial(m_bodies[b], pieceB, at))
               .norm() -
           touching;
  };
  if (s > low) {
    const Eigen::Vector2d normal = apart(beforeA, beforeB).normalized();
    const double rate = (rateOf(b, s) - rateOf(a, s)).dot(normal);
    const auto exact =
        polished(event, low, std::min(pieceA.end, pieceB.end), rate, polishTolerance(), gap);
    if (exact) {
      s = *exact;
      if (mustWait(event, s)) return;
      beforeA = m_stepper.partial(m_bodies[a], pieceA, s);
      beforeB = m_stepper.partial(m_bodies[b], pieceB, s);
    }
  }
  exchange(event, s, beforeA, beforeB, apart(beforeA, beforeB).normalized());
}

Eigen::Vector2d Engine::rateOf(int index, double s) const {
  const Piece& piece = m_moving[index].piece;
  const Entries rate = piece.rateAt(s);
  if (!isTethered(piece.mode)) return {rate[0], rate[1]};
  return m_bodies[index].length * rate[0] * trackOf(piece.at(s));
}

void Engine::exchange(const Upcoming& event, double s, const Entries& beforeA,
                      const Entries& beforeB, const Eigen::Vector2d& normal) {
  const int a = event.weight, b = event.other;
  const Piece pieceA = m_moving[a].piece, pieceB = m_moving[b].piece;
  const CollidingWeight weightA = colliding(a, pieceA.mode, beforeA);
  const CollidingWeight weightB = colliding(b, pieceB.mode, beforeB);
  const bool joins = joinAtRest(event, (weightA.velocity - weightB.velocity).dot(normal), normal);
  const double e = joins ? 0 : m_scene->restitution;
  if (joins || pieceA.settled || pieceB.settled) {
    std::vector<int> landing;
    for (const int i : {a, b})
      if (joins && !isSupported(i)) landing.push_back(i);
    for (const int i : {a, b}) {
      const Piece piece = m_moving[i].piece;
      const Entries& before = i == a ? beforeA : beforeB;
      const bool settles = piece.settled || joins;
      goOn(i, s, before, modeAfterPush(piece.mode, before, settles), before, piece.tied, settles);
      if (m_diverged) return;
    }
    return hitGroup(a, b, s, normal, e, landing);
  }
  const double impulse = collisionImpulse(weightA, weightB, normal, e);
  const Entries afterA = pushed(a, pieceA.mode, beforeA, weightA.velocityChange(-impulse, normal));
  const Entries afterB = pushed(b, pieceB.mode, beforeB, weightB.velocityChange(impulse, normal));
  if (impulse > 0)
    log(EventKind::kImpactWeight, s, a, readOut(a, pieceA.mode, pieceA.tied, beforeA),
        readOut(a, pieceA.mode, pieceA.tied, afterA), collisionLoss(weightA, weightB, normal, e),
        b);
  goOn(a, s, beforeA, modeAfterPush(pieceA.mode, afterA, false), afterA, pieceA.tied, false);
  if (m_diverged) return;
  goOn(b, s, beforeB, modeAfterPush(pieceB.mode, afterB, false), afterB, pieceB.tied, false);
  if (m_diverged) return;
  schedule(a);
  schedule(b);
}

bool Engine::joinAtRest(const Upcoming& event, double approach, const Eigen::Vector2d& normal) {
  const int a = event.weight, b = event.other;
  if (event.pressing || approach <= m_tolerance.speed) return true;
  const bool settled = m_moving[a].piece.settled || m_moving[b].piece.settled;
  // A bounce off one that lies, if it is over in no time: else the two share that time out.
  if (settled && 2 * approach < m_scene->gravity * m_solver.step * kLastDuration) return true;
  if (m_scene->restitution >= 1 && m_scene->room.restitution >= 1) return false;
  if (meetsTooOften(a, b)) return true;
  if (isSupported(a) && isSupported(b)) return settled && approach <= slowestHit();
  if (!isSupported(a) && !isSupported(b)) return false;
  // The free one bounces off the one that lies: gravity brings it back.
  const double pull = (isSupported(a) ? 1 : -1) * normal.y() * m_scene->gravity;
  const double rebound = m_scene->restitution * approach;
  const double radius = m_bodies[isSupported(a) ? b : a].radius;
  if (pull <= 0) return false;
  if (settled && 2 * rebound < pull * boundaryAfter(0)) return true;
  return rebound * rebound < 2 * pull * kLastRise * radius;
}

bool Engine::meetsTooOften(int a, int b) {
  const double steps = std::max(1.0, m_solver.step * 60);
  const auto isTooMuch = [&](int index, int other) {
    const int most = m_moving[other].piece.settled && !m_moving[index].piece.settled
                         ? kMostMeetingsWithGroup
                         : kMostMeetings;
    return ++m_moving[index].meetings > most * steps;
  };
  const bool tooMuchForA = isTooMuch(a, b);
  return isTooMuch(b, a) || tooMuchForA;
}

}  // namespace core
