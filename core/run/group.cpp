#include "core/run/group.h"

#include <algorithm>

namespace core {

Engine::Group::~Group() {
  for (const int i : members) m_engine.m_localOf[i] = -1;
}

void Engine::Group::add(int index) {
  if (localOf(index) >= 0) return;
  m_engine.m_localOf[index] = size();
  members.push_back(index);
  const Piece& piece = m_engine.m_moving[index].piece;
  const Entries state = piece.at(m_s);
  const Body& body = m_engine.m_bodies[index];
  places.push_back(positionOf(body, piece.mode, state));
  RestingWeight weight{velocityOf(body, piece.mode, state), body.mass};
  if (isTethered(piece.mode)) weight.track = trackOf(state);
  weights.push_back(weight);
  unkicked.push_back(weight.velocity);
  m_reach.push_back(reachAt(weight.velocity.norm()));
  m_expanded.push_back(false);
}

// How far a weight may come within the stretch, and some more for what pushes it [m].
double Engine::Group::reachAt(double speed) const {
  const double kick = 1.5 * m_engine.m_scene->gravity * m_duration;
  return 1.2 * (speed + kick) * m_duration + kTouchingGap;
}

void Engine::Group::expand(int local) {
  m_expanded[local] = true;
  addSurfacesOf(local);
  // A slow weight, too, must be told of a fast one that comes its way.
  const double farthest = m_reach[local] + reachAt(m_engine.m_fastestSettled);
  const double radius = m_engine.m_bodies[members[local]].radius;
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(radius + farthest);
  const Box box{places[local] - margin, places[local] + margin};
  m_engine.m_broadPhase.forEachNear(box, [&](int other) { lookAt(local, other); });
}

void Engine::Group::lookAt(int local, int other) {
  const int index = members[local];
  const Piece& piece = m_engine.m_moving[other].piece;
  if (other == index || !piece.settled) return;
  const Body& body = m_engine.m_bodies[other];
  const Entries state = piece.at(m_s);
  const Eigen::Vector2d apart = places[local] - positionOf(body, piece.mode, state);
  const double gap = apart.norm() - m_engine.m_bodies[index].radius - body.radius;
  const double reachThere = localOf(other) >= 0
                                ? m_reach[localOf(other)]
                                : reachAt(velocityOf(body, piece.mode, state).norm());
  if (gap > m_reach[local] + reachThere) return;
  add(other);
  const int lower = std::min(index, other), higher = std::max(index, other);
  if (!m_pairs.emplace(lower, higher).second) return;
  const Eigen::Vector2d normal = (index == lower ? 1 : -1) * apart.normalized();
  addContact({localOf(lower), localOf(higher), normal, gap - kSkin, 0, 0, 0}, higher);
}

void Engine::Group::addSurfacesOf(int local) {
  const Body& body = m_engine.m_bodies[members[local]];
  const Piece& piece = m_engine.m_moving[members[local]].piece;
  const Eigen::Vector2d place = places[local];
  const Room& room = m_engine.m_scene->room;
  const auto look = [&](Surface surface, double gap, const Eigen::Vector2d& normal,
                        double friction) {
    if (gap > m_reach[local] || !m_pairs.emplace(members[local], surface).second) return;
    addContact({local, -1, normal, gap, friction, 0, 0}, surface);
  };
  const double friction = isTethered(piece.mode) ? 0 : room.friction;
  look(kFloor, place.y() - body.radius, {0, 1}, friction);
  look(kCeiling, room.height - place.y() - body.radius, {0, -1}, friction);
  look(kWest, place.x() - body.radius, {1, 0}, friction);
  look(kEast, room.width - place.x() - body.radius, {-1, 0}, friction);
  if (!piece.tied || isTethered(piece.mode)) return;
  const Eigen::Vector2d out = place - body.pivot;
  if (out.norm() > 0) look(kRopeEnd, body.length - out.norm(), -out.normalized(), 0);
}

void Engine::Group::addContact(const RestingContact& contact, int key) {
  contacts.push_back(contact);
  keys.push_back(key);
}

void Engine::Group::solve(const ContactGoal& goal) {
  for (bool grows = true; grows;) {
    solveContacts(weights, contacts, m_duration, goal);
    grows = false;
    for (int local = 0; local < size(); ++local) {
      const double needed = reachAt(weights[local].velocity.norm());
      if (!m_expanded[local] || needed <= m_reach[local]) continue;
      m_reach[local] = 2 * needed;
      const std::size_t before = contacts.size();
      expand(local);
      grows = grows || contacts.size() > before;
    }
  }
}

void Engine::Group::markPushed() {
  for (const RestingContact& contact : contacts) {
    if (contact.push == 0) continue;
    hitOrHeld[contact.a] = 1;
    if (contact.b >= 0) hitOrHeld[contact.b] = 1;
  }
}

}  // namespace core
