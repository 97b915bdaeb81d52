#include <algorithm>
#include <cmath>

#include "core/run/engine.h"

namespace core {

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
    case Upcoming::Kind::kOwnStep:
      return beginOwnStep(event);
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
    if (done.polynomial) {
      done.endSlope = done.polynomial->rateAt(s - done.begin);
    } else if (!done.straight) {
      done.endSlope = m_stepper.pathEndSlope(m_bodies[index], done);
    }
    m_now.losses.friction += slideLoss(index, done, s);
    m_finished.push_back({done, moving.finished});
    moving.finished = static_cast<int>(m_finished.size()) - 1;
  }
  const double end = settled && !moving.asleep ? stretchEnd(s) : m_solver.step;
  moving.piece = {.begin = s, .end = end, .mode = mode, .tied = tied, .settled = settled};
  moving.piece.beginState = after;
  if (settled)
    m_fastestSettled = std::max(m_fastestSettled, velocityOf(m_bodies[index], mode, after).norm());
  ++moving.stamp;
  if (!fill(index)) return;
  m_boxes[index] = boxOf(m_bodies[index], moving.piece, s, moving.piece.end);
  m_broadPhase.move(index);
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
      polished(event, piece.begin, piece.end, piece.rateAt(event.time)[2], 0, [&](double at) {
        return m_stepper.partial(body, piece, at)[2];
      }).value_or(event.time);
  if (mustWait(event, s)) return;
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
      polished(event, piece.begin, piece.end, piece.rateAt(event.time)[3], 0, [&](double at) {
        return m_stepper.partial(m_bodies[i], piece, at)[3];
      }).value_or(event.time);
  if (mustWait(event, s)) return;
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
    s = polished(event, piece.begin, piece.end, rate, 0, tension).value_or(s);
  }
  if (mustWait(event, s)) return;
  const Entries before = m_stepper.partial(body, piece, s);
  const WeightState there = readOut(i, piece.mode, piece.tied, before);
  log(EventKind::kSlack, s, i, there, there, 0);
  goOn(i, s, before, Mode::kFlight, freed(i, piece.mode, before));
}

void Engine::stopSliding(const Upcoming& event) {
  const int i = event.weight;
  const Piece piece = m_moving[i].piece;
  const double s =
      polished(event, piece.begin, piece.end, piece.rateAt(event.time)[2], 0, [&](double at) {
        return m_stepper.partial(m_bodies[i], piece, at)[2];
      }).value_or(event.time);
  if (mustWait(event, s)) return;
  Entries before = m_stepper.partial(m_bodies[i], piece, s);
  before[2] = 0;
  goOn(i, s, before, Mode::kSlide, before);
}

}  // namespace core
