#include "core/run/group.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {
namespace {

// Overlaps deeper than this are deep [m]; in large heaps, which are solved more loosely, as much
// more.
constexpr double kSlight = 1e-6;
// Nor may anything leave the room by more than this share of its radius.
constexpr double kOutside = 1e-4;
// So often weights may evade those that stand; then they stand as well.
constexpr int kMostRounds = 50;

constexpr double kSlightBend = 1e-9;  // not worth solving again for [m]
constexpr int kMostBends = 10;        // so often at most
// A weight that turns further within a stretch is one that can hardly give way along its circle:
// what gives way for the bend would make it turn further still, without end [rad].
constexpr double kMostTurn = 0.1;
// What one that turns so far and runs into something has too much of: all of its speed.
constexpr double kStop = std::numeric_limits<double>::infinity();
// Looking along every turn of one that turns further than this takes too long [rad].
constexpr double kSurelyMeets = 1e3;

constexpr double kRounding = 1e-12;  // of velocities, as a share

constexpr double kNoNeed = std::numeric_limits<double>::infinity();  // to look for contacts

}  // namespace

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
  m_hasRopes = m_hasRopes || isTethered(piece.mode);
  weights.push_back(weight);
  unkicked.push_back(weight.velocity);
  told.push_back(weight.velocity - m_engine.m_moving[index].untold);
  m_reach.push_back(reachAt(weight.velocity.norm()));
  m_expanded.push_back(false);
  m_firstContact.push_back(-1);
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
  if (hasContact(local, other)) return;
  const int lower = std::min(index, other), higher = std::max(index, other);
  const Eigen::Vector2d normal = (index == lower ? 1 : -1) * apart.normalized();
  addContact({localOf(lower), localOf(higher), normal, gap, 0, 0, 0}, higher);
}

void Engine::Group::addSurfacesOf(int local) {
  const Body& body = m_engine.m_bodies[members[local]];
  const Piece& piece = m_engine.m_moving[members[local]].piece;
  const Eigen::Vector2d place = places[local];
  const Room& room = m_engine.m_scene->room;
  const auto look = [&](Surface surface, double gap, const Eigen::Vector2d& normal,
                        double friction) {
    if (gap > m_reach[local] || hasContact(local, surface)) return;
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

void Engine::Group::addHit(int a, int b, const Eigen::Vector2d& normal, double restitution) {
  for (const int index : {a, b}) {
    add(index);
    if (!m_engine.m_moving[index].piece.settled) m_reach[localOf(index)] = kNoNeed;
    if (!m_engine.m_moving[index].piece.settled) m_expanded[localOf(index)] = true;
  }
  const Eigen::Vector2d closing = weights[localOf(a)].velocity - weights[localOf(b)].velocity;
  const double speed = restitution * closing.dot(normal);
  m_hit = static_cast<int>(contacts.size());
  const double radii = m_engine.m_bodies[a].radius + m_engine.m_bodies[b].radius;
  const double realGap = (places[localOf(a)] - places[localOf(b)]).norm() - radii;
  link({localOf(a), localOf(b), -normal, -speed * m_duration, 0, 0, 0}, b, realGap);
}

void Engine::Group::undoHit() {
  for (std::size_t k = 0; k < weights.size(); ++k) {
    weights[k].velocity = unkicked[k];
    told[k] = unkicked[k] - m_engine.m_moving[members[k]].untold;
  }
  for (RestingContact& contact : contacts) contact.push = contact.drag = 0;
  contacts[m_hit].gap = m_straightGaps[m_hit] = 0;
}

/// A missing share of the skin is an approach that must not go on, as a negative gap. A hit only
/// sees to it that half of the skin stays, and no faster than a whole stretch would: what is
/// left of it may be so short that the gap would open with a blow.
///
/// Where a bounded number of sweeps leaves slow motions of a large heap unsolved, its pushes lag
/// behind. Gaps widened at once would then be widened too far: the heap would breathe and never
/// come to rest. Widened slowly enough they settle.
double Engine::Group::widened(double gap) const {
  const double skin = m_engine.skin();
  if (!m_widens)
    return std::min(0.0, gap + skin / 2) * std::min(1.0, m_duration / m_engine.boundaryAfter(0));
  const double overlap = std::min(0.0, gap + skin);
  const double looseness = m_engine.looseness();
  return overlap + (gap - overlap) / (looseness * looseness);
}

/// Adds one with the gap there is; the skin comes off it.
void Engine::Group::addContact(const RestingContact& contact, int key) {
  RestingContact added = contact;
  if (contact.b >= 0) added.gap -= m_engine.skin();
  if (added.gap < 0) added.gap = widened(added.gap);
  link(added, key, contact.gap);
}

/// @param realGap  without a skin [m]
void Engine::Group::link(const RestingContact& contact, int key, double realGap) {
  m_realGaps.push_back(realGap);
  const int i = static_cast<int>(contacts.size());
  contacts.push_back(contact);
  keys.push_back(key);
  m_straightGaps.push_back(contact.gap);
  m_nextContact.push_back({std::exchange(m_firstContact[contact.a], i),
                           contact.b < 0 ? -1 : std::exchange(m_firstContact[contact.b], i)});
}

bool Engine::Group::hasContact(int local, int key) const {
  bool found = false;
  forEachContact(local, [&](int i) {
    const int other = contacts[i].a == local ? keys[i] : members[contacts[i].a];
    found = found || other == key;
  });
  return found;
}

void Engine::Group::lookFurther(int local) {
  m_reach[local] = 2 * reachAt(weights[local].velocity.norm());
  expand(local);
}

void Engine::Group::solve(const ContactGoal& goal) {
  int bends = 0;
  for (bool again = true; again;) {
    solveContacts(weights, contacts, m_duration, goal);
    const std::size_t before = contacts.size();
    for (int local = 0; local < size(); ++local)
      if (m_expanded[local] && outruns(local)) lookFurther(local);
    again = contacts.size() > before || (bends < kMostBends && bend());
    ++bends;
  }
}

/// How far it leaves, within the stretch, the straight line along its velocity [m].
Eigen::Vector2d Engine::Group::bendOf(int local) const {
  const double turn = std::min(turnOf(local), kMostTurn);
  if (turn == 0) return {0, 0};
  const Body& body = m_engine.m_bodies[members[local]];
  const Eigen::Vector2d ahead = body.length * weights[local].velocity.normalized();
  return (1 - std::cos(turn)) * (body.pivot - places[local]) + (std::sin(turn) - turn) * ahead;
}

/// How much nearer than along straight lines the two of a contact come to each other [m], ≤ 0.
double Engine::Group::bendAt(const RestingContact& contact) const {
  Eigen::Vector2d apart = bendOf(contact.a);
  if (contact.b >= 0) apart -= bendOf(contact.b);
  return std::min(0.0, apart.dot(contact.normal));
}

/// Within the stretch, of one on a rope [rad].
double Engine::Group::turnOf(int local) const {
  if (weights[local].track.isZero(0)) return 0;
  return weights[local].velocity.norm() / m_engine.m_bodies[members[local]].length * m_duration;
}

bool Engine::Group::bend() {
  if (!m_hasRopes || !m_bends) return false;
  bool differs = false;
  for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
    RestingContact& contact = contacts[i];
    const double nearer = bendAt(contact);
    const double straight = m_straightGaps[i];
    const double gap = i == m_hit ? std::min(straight, nearer) : straight + nearer;
    if (gap > contact.gap - kSlightBend) continue;
    contact.gap = gap;
    differs = true;
  }
  return differs;
}

/// Whether it has left the group, so that its contacts are foreseen like anybody's.
bool Engine::Group::isLetGo(int local) const {
  return !support.empty() && support[local] != Support::kOthers;
}

/// Whether it turns so far within the stretch that its way is nothing like straight.
bool Engine::Group::turnsFar(int local) const {
  return turnOf(local) > kMostTurn && m_engine.m_moving[members[local]].piece.settled;
}

/// Its way within the stretch.
Piece Engine::Group::wayOf(int local) const {
  const int index = members[local];
  const Piece& now = m_engine.m_moving[index].piece;
  Piece way{.begin = m_s, .end = m_s + m_duration, .mode = now.mode, .tied = now.tied};
  way.settled = true;
  way.beginState = m_engine.withVelocity(index, now.mode, now.at(m_s), weights[local].velocity);
  m_engine.m_stepper.fill(m_engine.m_bodies[index], way);
  return way;
}

/// Whether the ways of the two of a contact cross.
bool Engine::Group::runsInto(const RestingContact& contact) const {
  if (turnOf(contact.a) > kSurelyMeets) return true;
  if (contact.b >= 0 && turnOf(contact.b) > kSurelyMeets) return true;
  const Body& body = m_engine.m_bodies[members[contact.a]];
  const Piece way = wayOf(contact.a);
  const Foresight& foresight = m_engine.m_foresight;
  if (contact.b < 0)
    return foresight.wall(body, way, boxOf(body, way, way.begin, way.end)).has_value();
  const Body& other = m_engine.m_bodies[members[contact.b]];
  return foresight.meeting(body, way, other, wayOf(contact.b)).has_value();
}

/// How much too fast the two of a contact approach each other [m/s]; 0 unless that leads deep
/// inside.
double Engine::Group::excessAt(std::size_t index) const {
  const RestingContact& contact = contacts[index];
  if (isLetGo(contact.a) || (contact.b >= 0 && isLetGo(contact.b))) return 0;
  if (turnsFar(contact.a) || (contact.b >= 0 && turnsFar(contact.b)))
    return runsInto(contact) ? kStop : 0;
  const Eigen::Vector2d still = Eigen::Vector2d::Zero();
  const Eigen::Vector2d& other = contact.b < 0 ? still : weights[contact.b].velocity;
  const double closing = (other - weights[contact.a].velocity).dot(contact.normal);
  const double nearer = closing * m_duration - bendAt(contact);
  if (nearer <= 0) return 0;
  const double depth = nearer - m_realGaps[index];
  double allowed = kSlight * m_engine.looseness();
  if (contact.b < 0)
    allowed = std::min(allowed, kOutside * m_engine.m_bodies[members[contact.a]].radius);
  return depth > allowed ? depth / m_duration : 0;
}

double Engine::Group::kineticEnergy() const {
  double energy = 0;
  for (const RestingWeight& weight : weights) energy += core::kineticEnergy(weight);
  return energy;
}

double Engine::Group::kineticEnergyBefore() const {
  double energy = 0;
  for (std::size_t k = 0; k < weights.size(); ++k)
    energy += core::kineticEnergy({unkicked[k], weights[k].mass});
  return energy;
}

/// What turns away may run into others, which may be new here.
void Engine::Group::meetOthers(int local) {
  if (local < 0 || m_expanded[local]) return;
  expand(local);
  if (!support.empty()) support.resize(members.size(), Support::kOthers);
}

double Engine::Group::stopUnsolved() {
  bool isSolved = true;
  for (std::size_t i = 0; isSolved && i < contacts.size(); ++i) isSolved = excessAt(i) == 0;
  if (isSolved) return 0;  // as nearly always
  double before = kineticEnergy();
  const std::size_t known = members.size();
  std::vector<char> stands;
  const auto stop = [&](int local) {
    weights[local].velocity.setZero();
    stands[local] = 1;
  };
  const auto energyOf = [&](int local) { return core::kineticEnergy(weights[local]); };
  for (int round = 0; !isSolved; ++round) {
    isSolved = true;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const double excess = excessAt(i);
      if (excess == 0) continue;
      isSolved = false;
      const auto [a, b] = std::pair(contacts[i].a, contacts[i].b);
      for (const int local : {a, b}) meetOthers(local);
      stands.resize(members.size());
      const bool isWall = b < 0 || stands[b];
      RestingWeight& moving = weights[isWall ? a : b];
      if ((isWall || stands[a]) && moving.track.isZero() && round < kMostRounds) {
        moving.velocity += (isWall ? excess : -excess) * contacts[i].normal;
        continue;
      }
      stop(isWall || (!stands[a] && energyOf(a) < energyOf(b)) ? a : b);
    }
  }
  for (std::size_t k = known; k < members.size(); ++k)
    before += core::kineticEnergy({unkicked[k], weights[k].mass});
  return std::max(0.0, before - kineticEnergy());
}

double Engine::Group::loss() const {
  return pushLoss(contacts, unkicked, weights) + dragLoss(contacts, unkicked, weights);
}

void Engine::Group::findSupport() {
  support.assign(members.size(), Support::kNone);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const RestingContact& contact = contacts[i];
    if (contact.b >= 0 && isPushed(contact.b, contact.push)) support[contact.b] = Support::kOthers;
    if (!isPushed(contact.a, contact.push)) continue;
    Support& of = support[contact.a];
    const bool onFloor = keys[i] == kFloor && std::abs(contact.gap) <= kTouchingGap &&
                         !m_engine.m_moving[members[contact.a]].piece.tied;
    of = onFloor && of == Support::kNone ? Support::kFloor : Support::kOthers;
  }
}

/// Whether a push changes a member's velocity by more than rounding does.
bool Engine::Group::isPushed(int local, double push) const {
  const double rounding = m_engine.m_tolerance.speed + kRounding * weights[local].velocity.norm();
  return push > rounding * weights[local].mass;
}

}  // namespace core
