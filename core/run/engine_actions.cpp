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

/// A bounce that would rise by less than this share of the radius is the last one.
constexpr double kLastRise = 1e-6;
/// So is, for weights that do not only bounce elastically, the contact after this many within
/// 1/60 s or a step: between weights in a heap the series of bounces need not end.
constexpr int kMostMeetings = 64;
/// So is one that would be over within this share of the step, whatever the restitution.
constexpr double kLastDuration = 1e-7;

}  // namespace

template <class Value>
std::optional<double> Engine::polished(double s, double low, double high, double rate,
                                       double tolerance, const Value& value) {
  double previous = s, previousValue = value(s);
  if (std::abs(previousValue) <= tolerance) return s;
  double guess = std::clamp(s - previousValue / rate, low, high);
  for (int i = 0; i < 10; ++i) {
    const double here = value(guess);
    if (std::abs(here) <= tolerance) return guess;
    const double next = guess - here * (guess - previous) / (here - previousValue);
    if (!(low <= next && next <= high)) return std::nullopt;
    if (std::abs(next - guess) <= 1e-15 * high) return next;
    previous = guess;
    previousValue = here;
    guess = next;
  }
  return std::nullopt;
}

void Engine::act(const Upcoming& event) {
  switch (event.kind) {
    case Upcoming::Kind::kCut:
      return cutAllAt(event.time);
    case Upcoming::Kind::kWeight:
      return meet(event);
    case Upcoming::Kind::kTurningPoint:
      return passTurningPoint(event);
    case Upcoming::Kind::kApex:
      return passApex(event);
    case Upcoming::Kind::kSlack:
      return goSlack(event);
    case Upcoming::Kind::kTaut:
      return goTaut(event);
    case Upcoming::Kind::kStop:
      return stopSliding(event);
    case Upcoming::Kind::kSettle:
      return settle(event.time, true);
    case Upcoming::Kind::kFloor:
    case Upcoming::Kind::kCeiling:
    case Upcoming::Kind::kWest:
    case Upcoming::Kind::kEast:
      return hitWall(event);
  }
}

void Engine::goOn(int index, double s, const Entries& before, Mode mode, const Entries& after,
                  bool tied, bool settled) {
  Moving& moving = m_moving[index];
  if (s > moving.piece.begin) {
    Piece done = moving.piece;
    done.end = s;
    done.endState = before;
    if (!done.straight) done.endSlope = m_stepper.slopeOn(m_bodies[index], done, before);
    m_now.losses.friction += slideLoss(index, done, s);
    m_finished.push_back({done, moving.finished});
    moving.finished = static_cast<int>(m_finished.size()) - 1;
  }
  const double end = settled && !moving.asleep ? boundaryAfter(s) : m_solver.step;
  moving.piece = {.begin = s, .end = end, .mode = mode, .tied = tied, .settled = settled};
  moving.piece.beginState = after;
  if (settled)
    m_fastestSettled = std::max(m_fastestSettled, velocityOf(m_bodies[index], mode, after).norm());
  m_stepper.fill(m_bodies[index], moving.piece);
  ++moving.stamp;
  if (!isFinite(index)) {
    m_diverged = true;
    return;
  }
  m_boxes[index] = boxOf(m_bodies[index], moving.piece, s, end);
  m_broadPhase.move(index, m_boxes[index]);
}

void Engine::goOn(int index, double s, const Entries& before, Mode mode, const Entries& after) {
  goOn(index, s, before, mode, after, m_moving[index].piece.tied, false);
  if (!m_diverged) schedule(index);
}

Entries Engine::freed(int index, Mode mode, const Entries& state) const {
  if (!isTethered(mode)) return state;
  return flightEntries(positionOf(m_bodies[index], mode, state),
                       velocityOf(m_bodies[index], mode, state), state[4]);
}

void Engine::cutAllAt(double s) {
  m_now.cutTimePassed = true;
  log(EventKind::kCut, s, -1, {}, {}, 0);
  std::vector<int> cut;
  for (int i = 0; i < static_cast<int>(m_bodies.size()); ++i) {
    const Piece& piece = m_moving[i].piece;
    if (!piece.tied) continue;
    cut.push_back(i);
    const Entries before = m_stepper.partial(m_bodies[i], piece, s);
    const Mode mode = isTethered(piece.mode) ? Mode::kFlight : piece.mode;
    m_moving[i].asleep = false;
    goOn(i, s, before, mode, freed(i, piece.mode, before), false, piece.settled);
    if (m_diverged) return;
  }
  for (const int i : cut) schedule(i);
}

void Engine::passTurningPoint(const Upcoming& event) {
  const int i = event.weight;
  const Body& body = m_bodies[i];
  const Piece piece = m_moving[i].piece;
  const double s =
      polished(event.time, piece.begin, piece.end, piece.rateAt(event.time)[2], 0, [&](double at) {
        return m_stepper.partial(body, piece, at)[2];
      }).value_or(event.time);
  Entries before = m_stepper.partial(body, piece, s);
  before[2] = 0;
  const WeightState there = readOut(i, piece.mode, piece.tied, before);
  log(EventKind::kTurningPoint, s, i, there, there, 0);
  // Only drag has a kink where the speed passes zero.
  if (body.drag > 0 && method().mindsKinks()) {
    goOn(i, s, before, piece.mode, before);
  } else {
    scheduleTurningPoint(i, std::max(s, event.time));
  }
}

void Engine::passApex(const Upcoming& event) {
  const int i = event.weight;
  const Piece piece = m_moving[i].piece;
  const double s =
      polished(event.time, piece.begin, piece.end, piece.rateAt(event.time)[3], 0, [&](double at) {
        return m_stepper.partial(m_bodies[i], piece, at)[3];
      }).value_or(event.time);
  Entries before = m_stepper.partial(m_bodies[i], piece, s);
  before[3] = 0;
  goOn(i, s, before, piece.mode, before);
}

void Engine::goSlack(const Upcoming& event) {
  const int i = event.weight;
  const Body& body = m_bodies[i];
  const Piece piece = m_moving[i].piece;
  const auto tension = [&](double at) {
    return m_foresight.tension(body, m_stepper.partial(body, piece, at));
  };
  double s = event.time;
  if (s > piece.begin) {
    const Entries state = piece.at(s), slope = piece.rateAt(s);
    const double rate =
        -m_scene->gravity * std::sin(state[0]) * slope[0] + 2 * body.length * state[2] * slope[2];
    s = polished(s, piece.begin, piece.end, rate, 0, tension).value_or(s);
  }
  const Entries before = m_stepper.partial(body, piece, s);
  const WeightState there = readOut(i, piece.mode, piece.tied, before);
  log(EventKind::kSlack, s, i, there, there, 0);
  goOn(i, s, before, Mode::kFlight, freed(i, piece.mode, before));
}

void Engine::goTaut(const Upcoming& event) {
  const int i = event.weight;
  const Body& body = m_bodies[i];
  const Piece piece = m_moving[i].piece;
  const auto spare = [&](double at) {
    const Entries state = m_stepper.partial(body, piece, at);
    return body.length - (positionOf(body, piece.mode, state) - body.pivot).norm();
  };
  Entries before = piece.at(event.time);
  double s = event.time;
  if (s > piece.begin) {
    const Eigen::Vector2d out = positionOf(body, piece.mode, before) - body.pivot;
    const Eigen::Vector2d rate = piece.rateAt(s).head<2>().transpose();
    const auto exact = polished(s, piece.begin, piece.end, -rate.dot(out) / out.norm(),
                                m_tolerance.gap / 4, spare);
    if (exact) {
      s = *exact;
      before = m_stepper.partial(body, piece, s);
    }
  }
  const Eigen::Vector2d out = positionOf(body, piece.mode, before) - body.pivot;
  const Eigen::Vector2d radial = out.normalized();
  const Eigen::Vector2d track(-radial.y(), radial.x());
  const Eigen::Vector2d velocity = velocityOf(body, piece.mode, before);
  const double jerk = velocity.dot(radial);
  Entries after;
  after << std::atan2(out.x(), -out.y()), 0, velocity.dot(track) / body.length, 0, before[4];
  log(EventKind::kTaut, s, i, readOut(i, piece.mode, true, before),
      readOut(i, Mode::kSwing, true, after), 0.5 * body.mass * jerk * jerk);
  goOn(i, s, before, Mode::kSwing, after);
}

void Engine::stopSliding(const Upcoming& event) {
  const int i = event.weight;
  const Piece piece = m_moving[i].piece;
  const double s =
      polished(event.time, piece.begin, piece.end, piece.rateAt(event.time)[2], 0, [&](double at) {
        return m_stepper.partial(m_bodies[i], piece, at)[2];
      }).value_or(event.time);
  Entries before = m_stepper.partial(m_bodies[i], piece, s);
  before[2] = 0;
  goOn(i, s, before, Mode::kSlide, before);
}

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
    const auto exact = polished(s, piece.begin, piece.end, rate, m_tolerance.gap / 4,
                                [&](double at) { return gap(m_stepper.partial(body, piece, at)); });
    if (exact) {
      s = *exact;
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
  const double pull = -inwardAcceleration;
  if (m_scene->room.restitution < 1 && speedAfter * speedAfter < 2 * pull * kLastRise * radius)
    return true;
  return 2 * speedAfter < pull * m_solver.step * kLastDuration;
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
        polished(s, low, std::min(pieceA.end, pieceB.end), rate, m_tolerance.gap / 4, gap);
    if (exact) s = *exact;
    if (exact) {
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
  const double approach = (weightA.velocity - weightB.velocity).dot(normal);
  const bool joins = joinAtRest(event, approach, normal);
  const double e = joins ? 0 : m_scene->restitution;
  const double impulse = collisionImpulse(weightA, weightB, normal, e);
  const Entries afterA = pushed(a, pieceA.mode, beforeA, weightA.velocityChange(-impulse, normal));
  const Entries afterB = pushed(b, pieceB.mode, beforeB, weightB.velocityChange(impulse, normal));
  if (impulse > 0)
    log(EventKind::kImpactWeight, s, a, readOut(a, pieceA.mode, pieceA.tied, beforeA),
        readOut(a, pieceA.mode, pieceA.tied, afterA), collisionLoss(weightA, weightB, normal, e),
        b);
  const bool settlesA = pieceA.settled || joins;
  const bool settlesB = pieceB.settled || joins;
  if (impulse > 0) {
    if (settlesA && !isSupported(a)) logRest(a, s, afterA);
    if (settlesB && !isSupported(b)) logRest(b, s, afterB);
  }
  goOn(a, s, beforeA, modeAfterPush(pieceA.mode, afterA, settlesA), afterA, pieceA.tied, settlesA);
  if (m_diverged) return;
  goOn(b, s, beforeB, modeAfterPush(pieceB.mode, afterB, settlesB), afterB, pieceB.tied, settlesB);
  if (m_diverged) return;
  std::vector<int> settled;
  if (settlesA) settled.push_back(a);
  if (settlesB) settled.push_back(b);
  if (!settled.empty()) spread(s, settled, approach);
  if (m_diverged) return;
  schedule(a);
  schedule(b);
}

void Engine::logRest(int index, double s, const Entries& state) {
  const Piece& piece = m_moving[index].piece;
  const WeightState there = readOut(index, piece.mode, piece.tied, state);
  log(EventKind::kRest, s, index, there, there, 0);
}

bool Engine::joinAtRest(const Upcoming& event, double approach, const Eigen::Vector2d& normal) {
  const int a = event.weight, b = event.other;
  if (event.pressing || approach <= m_tolerance.speed) return true;
  if (m_scene->restitution >= 1 && m_scene->room.restitution >= 1) return false;
  const int meetings = std::max(++m_moving[a].meetings, ++m_moving[b].meetings);
  const double steps = std::max(1.0, m_solver.step * 60);
  if (meetings > kMostMeetings * steps) return true;
  // Between two solves a settled weight moves with the velocity a whole stretch of gravity
  // gave it: so slow a hit is a lean.
  const bool settled = m_moving[a].piece.settled || m_moving[b].piece.settled;
  if (isSupported(a) && isSupported(b))
    return settled && approach <= 2 * m_scene->gravity * boundaryAfter(0);
  if (!isSupported(a) && !isSupported(b)) return false;
  // The free one bounces off the one that lies: gravity brings it back.
  const double pull = (isSupported(a) ? 1 : -1) * normal.y() * m_scene->gravity;
  const double rebound = m_scene->restitution * approach;
  const double radius = m_bodies[isSupported(a) ? b : a].radius;
  return pull > 0 && rebound * rebound < 2 * pull * kLastRise * radius;
}

}  // namespace core
