#include <algorithm>
#include <cmath>

#include "core/run/engine.h"

namespace core {
namespace {

Phase phaseOf(Mode mode, bool tied, bool settled) {
  switch (mode) {
    case Mode::kSwing:
    case Mode::kHeld:
      return Phase::kTethered;
    case Mode::kSlide:
      return Phase::kResting;
    case Mode::kFlight:
      break;
  }
  if (settled) return Phase::kResting;
  return tied ? Phase::kSlack : Phase::kFlying;
}

void addMechanical(Energies& energies, const Body& body, double gravity, Mode mode,
                   const Entries& state) {
  energies.kinetic += 0.5 * body.mass * velocityOf(body, mode, state).squaredNorm();
  energies.potential += body.mass * gravity * positionOf(body, mode, state).y();
  energies.lostToAir += state[4];
}

/// Which account of the ledger an event's loss goes to.
void addLoss(Losses& losses, const Event& event) {
  (event.kind == EventKind::kTaut ? losses.ropes : losses.impacts) += event.energyLost;
}

Energies balanced(Energies energies, const Losses& losses, double startEnergy) {
  energies.lostToImpacts = losses.impacts;
  energies.lostToRopes = losses.ropes;
  energies.lostToFriction = losses.friction;
  energies.numericalDrift = energies.accounted() - startEnergy;
  return energies;
}

}  // namespace

WeightState Engine::readOut(int index, Mode mode, bool tied, const Entries& state) const {
  const Body& body = m_bodies[index];
  WeightState result;
  result.phase = phaseOf(mode, tied, false);
  result.position = positionOf(body, mode, state);
  result.velocity = velocityOf(body, mode, state);
  if (isTethered(mode)) {
    result.angle = state[0];
    result.angularVelocity = state[2];
    result.tension = body.mass * m_foresight.tension(body, state);
  }
  return result;
}

WeightState Engine::weight(int index) const {
  const WeightRecord& record = m_now.weights[index];
  WeightState result = readOut(index, record.mode, record.tied, record.state);
  result.phase = phaseOf(record.mode, record.tied, record.settled);
  return result;
}

WeightState Engine::weightAt(int index, double time) const {
  if (m_moving.empty() || time >= this->time()) return weight(index);
  const double s = time - static_cast<double>(m_before.stepCount) * m_solver.step;
  const Piece& piece = pieceAt(index, s);
  WeightState result = readOut(index, piece.mode, piece.tied, piece.at(s));
  result.phase = phaseOf(piece.mode, piece.tied, piece.settled);
  return result;
}

const Piece& Engine::pieceAt(int index, double s) const {
  const Moving& moving = m_moving[index];
  const Piece* piece = &moving.piece;
  for (int i = moving.finished; s < piece->begin && i >= 0; i = m_finished[i].previous)
    piece = &m_finished[i].piece;
  return *piece;
}

Energies Engine::energies() const {
  Energies energies;
  for (std::size_t i = 0; i < m_bodies.size(); ++i)
    addMechanical(energies, m_bodies[i], m_scene->gravity, m_now.weights[i].mode,
                  m_now.weights[i].state);
  return balanced(energies, m_now.losses, m_startEnergy);
}

Energies Engine::energiesAt(double time) const {
  if (m_moving.empty() || time >= this->time()) return energies();
  const double s = time - static_cast<double>(m_before.stepCount) * m_solver.step;
  Energies energies;
  Losses losses = m_before.losses;
  for (int i = 0; i < static_cast<int>(m_bodies.size()); ++i) {
    const Piece& piece = pieceAt(i, s);
    addMechanical(energies, m_bodies[i], m_scene->gravity, piece.mode, piece.at(s));
    losses.friction += slideLoss(i, piece, s);
    for (int j = m_moving[i].finished; j >= 0; j = m_finished[j].previous) {
      const Piece& earlier = m_finished[j].piece;
      if (earlier.end <= piece.begin) losses.friction += slideLoss(i, earlier, earlier.end);
    }
  }
  for (std::size_t i = 0; i < m_events.size() && m_eventMoments[i] <= s; ++i)
    addLoss(losses, m_events[i]);
  for (const QuietLoss& loss : m_quietLosses) {
    if (loss.moment > s) break;
    losses.impacts += loss.losses.impacts;
    losses.friction += loss.losses.friction;
  }
  return balanced(energies, losses, m_startEnergy);
}

void Engine::log(EventKind kind, double s, int weight, const WeightState& before,
                 const WeightState& after, double energyLost, int other) {
  Event event;
  event.time = kind == EventKind::kCut ? *m_scene->cutTime : time() + s;
  event.kind = kind;
  event.weight = weight;
  event.other = other;
  event.position = before.position;
  event.energyLost = energyLost;
  event.speedBefore = before.velocity.norm();
  event.speedAfter = after.velocity.norm();
  addLoss(m_now.losses, event);
  // Polishing may move a moment to before others of the step that are over.
  const auto place = std::ranges::upper_bound(m_events, event.time, {}, &Event::time);
  m_eventMoments.insert(m_eventMoments.begin() + (place - m_events.begin()), s);
  m_events.insert(place, event);
}

}  // namespace core
