#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core/contact/resting.h"
#include "core/run/engine.h"

// Weights in lasting contact move in groups, by time-stepping: every so often the forces
// that keep them apart are found together, and in between each keeps its velocity. First
// order, but nothing overlaps, nothing stalls, and energy only falls: core/model.md, "Rest".

namespace core {
namespace {

// Forces in groups are found anew this often [1/s].
constexpr double kSolvesPerSecond = 240;
// Velocities of solved contacts are right to this [m/s].
constexpr double kSolverTolerance = 1e-8;
// After a hit, until the next solve, this is enough [m/s], or this share of the hit.
constexpr double kHitTolerance = 1e-6;
constexpr double kHitShare = 1e-5;
constexpr int kMostSweeps = 600;
// A group falls asleep when all its weights have been slower than this share of √(2 g r)
// for this many times √(2 r / g), the time in which what stands on a point leaves it by a
// factor of e: one that sets out to roll off another from 10⁻⁸ r off its top is faster by
// then.
constexpr double kStillSpeed = 1e-4;
constexpr double kStillTimes = 10;
// Gaps up to this count as touching within a group [m].
constexpr double kTouchingGap = 1e-9;

enum Surface { kFloor = -1, kCeiling = -2, kWest = -3, kEast = -4, kRopeEnd = -5 };

}  // namespace

/// Some settled weights with their contacts, in the solver's terms.
class Engine::Group {
 public:
  Group(Engine& engine, double s, double duration)
      : m_engine(engine), m_s(s), m_duration(duration) {}
  ~Group() {
    for (const int i : members) m_engine.m_localOf[i] = -1;
  }
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

  void add(int index) {
    if (localOf(index) >= 0) return;
    m_engine.m_localOf[index] = static_cast<int>(members.size());
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

  int localOf(int index) const { return m_engine.m_localOf[index]; }
  bool isExpanded(int local) const { return m_expanded[local]; }

  /// Finds all contacts of a member within its reach; settled weights it finds become members.
  void expand(int local) {
    m_expanded[local] = true;
    addSurfacesOf(local);
    const int index = members[local];
    const double radius = m_engine.m_bodies[index].radius;
    // A slow weight, too, must be told of a fast one that comes its way.
    const double farthest = m_reach[local] + reachAt(m_engine.m_fastestSettled);
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(radius + farthest);
    const Box box{places[local] - margin, places[local] + margin};
    m_engine.m_broadPhase.forEachNear(box, [&](int other) {
      if (other == index || !m_engine.m_moving[other].piece.settled) return;
      const Piece& piece = m_engine.m_moving[other].piece;
      const Body& body = m_engine.m_bodies[other];
      const Entries state = piece.at(m_s);
      const Eigen::Vector2d apart = places[local] - positionOf(body, piece.mode, state);
      const double gap = apart.norm() - radius - body.radius;
      const double reachThere = localOf(other) >= 0
                                    ? m_reach[localOf(other)]
                                    : reachAt(velocityOf(body, piece.mode, state).norm());
      if (gap > m_reach[local] + reachThere) return;
      add(other);
      const int lower = std::min(index, other), higher = std::max(index, other);
      if (!m_pairs.emplace(lower, higher).second) return;
      const Eigen::Vector2d normal = (index == lower ? 1 : -1) * apart.normalized();
      addContact({localOf(lower), localOf(higher), normal, gap, 0, 0, 0}, higher);
    });
  }

  /// Solves; when that made members faster than their contacts were looked for, looks again.
  void solve(double tolerance) {
    for (bool grows = true; grows;) {
      ContactSolver(weights, contacts).solve(m_duration, tolerance, kMostSweeps);
      grows = false;
      for (int local = 0; local < static_cast<int>(members.size()); ++local) {
        const double needed = reachAt(weights[local].velocity.norm());
        if (!m_expanded[local] || needed <= m_reach[local]) continue;
        m_reach[local] = 2 * needed;
        const std::size_t before = contacts.size();
        expand(local);
        grows = grows || contacts.size() > before;
      }
    }
  }

  /// Notes the members that some contact pushes now.
  void markPushed() {
    for (const RestingContact& contact : contacts) {
      if (contact.push == 0) continue;
      hitOrHeld[contact.a] = 1;
      if (contact.b >= 0) hitOrHeld[contact.b] = 1;
    }
  }

  std::vector<int> members;              // indices of weights
  std::vector<RestingWeight> weights;    // in the order of members
  std::vector<Eigen::Vector2d> places;   // likewise [m]
  std::vector<RestingContact> contacts;  // refer to places in `members`
  std::vector<int> keys;                 // of contacts: other weight, or Surface
  /// Velocities when they became members; from solveImpacts() on, those after impacts and
  /// before forces [m/s].
  std::vector<Eigen::Vector2d> unkicked;
  std::vector<char> hitOrHeld;  // of members: some contact pushes

 private:
  /// How far a weight may come within the stretch, and some more for what pushes it [m].
  double reachAt(double speed) const {
    const double kick = 1.5 * m_engine.m_scene->gravity * m_duration;
    return 1.2 * (speed + kick) * m_duration + kTouchingGap;
  }

  void addSurfacesOf(int local) {
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

  void addContact(const RestingContact& contact, int key) {
    contacts.push_back(contact);
    keys.push_back(key);
  }

  Engine& m_engine;
  double m_s;
  double m_duration;
  std::vector<double> m_reach;  // of members: how far their contacts were looked for [m]
  std::vector<bool> m_expanded;
  std::set<std::pair<int, int>> m_pairs;  // weights, or weight and Surface, with a contact
};

double Engine::boundaryAfter(double s) const {
  const double count = std::ceil(m_solver.step * kSolvesPerSecond - 1e-9);
  const double part = m_solver.step / std::max(1.0, count);
  return std::min(m_solver.step, (std::floor(s / part + 1e-6) + 1) * part);
}

std::vector<int> Engine::wakeTouching() {
  std::vector<int> members;
  std::vector<int> open;
  for (int i = 0; i < static_cast<int>(m_moving.size()); ++i)
    if (m_moving[i].piece.settled && !m_moving[i].asleep) open.push_back(i);
  while (!open.empty()) {
    const int index = open.back();
    open.pop_back();
    members.push_back(index);
    const Piece& piece = m_moving[index].piece;
    const Eigen::Vector2d place = positionOf(m_bodies[index], piece.mode, piece.endState);
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(m_bodies[index].radius + kTouchingGap);
    m_broadPhase.forEachNear({place - margin, place + margin}, [&](int other) {
      Moving& moving = m_moving[other];
      if (!moving.asleep) return;
      const Eigen::Vector2d there =
          positionOf(m_bodies[other], moving.piece.mode, moving.piece.beginState);
      const double touching = m_bodies[index].radius + m_bodies[other].radius + kTouchingGap;
      if ((there - place).squaredNorm() > touching * touching) return;
      moving.asleep = false;
      moving.stillFor = 0;
      open.push_back(other);
    });
  }
  std::ranges::sort(members);
  return members;
}

void Engine::settle(double s, bool foresee) {
  const std::vector<int> members = wakeTouching();
  if (members.empty()) return;
  const double duration = boundaryAfter(s) - s;
  Group group(*this, s, duration);
  for (const int i : members) group.add(i);
  m_fastestSettled = 0;
  for (const RestingWeight& weight : group.weights)
    m_fastestSettled = std::max(m_fastestSettled, weight.velocity.norm());
  for (int local = 0; local < static_cast<int>(members.size()); ++local) group.expand(local);
  solveImpacts(group, s);
  solveSupport(group, s, duration);
  carryImpulses(group);
  fallAsleep(group, s, duration);
  releaseOrKeep(group, s, foresee);
}

void Engine::solveImpacts(Group& group, double s) {
  group.solve(kSolverTolerance);
  loseQuietly(s, inelasticLoss(group.contacts, group.unkicked, group.weights), 0);
  group.hitOrHeld.assign(group.members.size(), 0);
  group.markPushed();
  for (std::size_t k = 0; k < group.members.size(); ++k)
    group.unkicked[k] = group.weights[k].velocity;
}

void Engine::solveSupport(Group& group, double s, double duration) {
  for (std::size_t k = 0; k < group.members.size(); ++k) {
    const int index = group.members[k];
    const Piece& piece = m_moving[index].piece;
    Entries state = piece.at(s);
    state = withVelocity(index, piece.mode, state, group.unkicked[k]);
    const Entries slope = m_stepper.slope(m_bodies[index], piece.mode, state);
    group.weights[k].velocity +=
        isTethered(piece.mode)
            ? Eigen::Vector2d(duration * m_bodies[index].length * slope[2] * trackOf(state))
            : Eigen::Vector2d(duration * slope[2], duration * slope[3]);
  }
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    RestingContact& contact = group.contacts[i];
    const std::pair key(group.members[contact.a], group.keys[i]);
    const auto carried = std::ranges::lower_bound(
        m_now.contacts, key, {}, [](const CarriedContact& c) { return std::pair(c.a, c.b); });
    const bool found = carried != m_now.contacts.end() && std::pair(carried->a, carried->b) == key;
    contact.push = found ? carried->push : 0;
    contact.drag = found ? carried->drag : 0;
  }
  ContactSolver(group.weights, group.contacts).applyCarried();
  group.solve(kSolverTolerance);
  loseQuietly(s, 0, slipLoss(group.contacts, group.weights));
  group.markPushed();
}

void Engine::carryImpulses(const Group& group) {
  std::vector<CarriedContact> carried;
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    const RestingContact& contact = group.contacts[i];
    if (contact.push > 0)
      carried.push_back({group.members[contact.a], group.keys[i], contact.push, contact.drag});
  }
  for (const CarriedContact& contact : m_now.contacts)
    if (m_moving[contact.a].asleep) carried.push_back(contact);
  std::ranges::sort(carried, {}, [](const CarriedContact& c) { return std::pair(c.a, c.b); });
  m_now.contacts = std::move(carried);
}

void Engine::fallAsleep(const Group& group, double s, double duration) {
  std::vector<int> parent(group.members.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  for (const RestingContact& contact : group.contacts)
    if (contact.b >= 0 && (contact.push > 0 || contact.gap <= kTouchingGap))
      parent[root(contact.a)] = root(contact.b);
  std::vector<char> mayRest(group.members.size(), 1);
  for (int k = 0; k < static_cast<int>(group.members.size()); ++k) {
    Moving& moving = m_moving[group.members[k]];
    const double size = 2 * m_bodies[group.members[k]].radius;
    const double gravity = m_scene->gravity;
    const bool still = group.weights[k].velocity.norm() <= kStillSpeed * std::sqrt(gravity * size);
    moving.stillFor = still && group.hitOrHeld[k] ? moving.stillFor + duration : 0;
    if (!(moving.stillFor * moving.stillFor * gravity > kStillTimes * kStillTimes * size))
      mayRest[root(k)] = 0;
  }
  double lost = 0;
  for (int k = 0; k < static_cast<int>(group.members.size()); ++k) {
    m_moving[group.members[k]].asleep = mayRest[root(k)];
    if (mayRest[root(k)])
      lost += 0.5 * group.weights[k].mass * group.weights[k].velocity.squaredNorm();
  }
  loseQuietly(s, lost, 0);
}

void Engine::releaseOrKeep(const Group& group, double s, bool foresee) {
  std::vector<char> leansOn(group.members.size(), 0);  // something besides the floor pushes
  std::vector<double> floorGap(group.members.size(), 1);
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    const RestingContact& contact = group.contacts[i];
    if (group.keys[i] == kFloor) floorGap[contact.a] = contact.gap;
    if (contact.push == 0 || group.keys[i] == kFloor) continue;
    leansOn[contact.a] = 1;
    if (contact.b >= 0) leansOn[contact.b] = 1;
  }
  for (std::size_t k = 0; k < group.members.size(); ++k) {
    const int index = group.members[k];
    const Piece piece = m_moving[index].piece;
    const Entries before = piece.at(s);
    const bool onFloorAlone =
        group.hitOrHeld[k] && !leansOn[k] && !piece.tied && std::abs(floorGap[k]) <= kTouchingGap;
    Eigen::Vector2d velocity = group.weights[k].velocity;
    if (m_moving[index].asleep) velocity.setZero();
    if (!group.hitOrHeld[k] || onFloorAlone) {
      velocity = group.unkicked[k];
      m_moving[index].asleep = false;
    }
    Entries after = withVelocity(index, piece.mode, before, velocity);
    if (onFloorAlone) {
      after[1] = m_bodies[index].radius;
      after[3] = 0;
    }
    const bool stays = group.hitOrHeld[k] && !onFloorAlone;
    goOn(index, s, before, onFloorAlone ? Mode::kSlide : piece.mode, after, piece.tied, stays);
    if (m_diverged) return;
  }
  if (!foresee) return;
  for (const int i : group.members) schedule(i);
}

void Engine::spread(double s, const std::vector<int>& seeds, double approach) {
  const double tolerance = std::max(kHitTolerance, kHitShare * approach);
  Group group(*this, s, std::max(boundaryAfter(s) - s, 1e-9));
  for (const int i : seeds) group.add(i);
  for (bool reaches = true; reaches;) {
    reaches = false;
    for (int local = 0, count = static_cast<int>(group.members.size()); local < count; ++local) {
      const double change = (group.weights[local].velocity - group.unkicked[local]).norm();
      const bool isHit = local < static_cast<int>(seeds.size()) || change > tolerance;
      if (!isHit || group.isExpanded(local)) continue;
      group.expand(local);
      reaches = true;
    }
    if (reaches) group.solve(tolerance);
  }
  loseQuietly(s, inelasticLoss(group.contacts, group.unkicked, group.weights), 0);
  moveSpread(group, s);
}

void Engine::moveSpread(const Group& group, double s) {
  std::vector<int> moved;
  for (std::size_t k = 0; k < group.members.size(); ++k) {
    if (group.weights[k].velocity == group.unkicked[k]) continue;
    const int index = group.members[k];
    moved.push_back(index);
    m_moving[index].asleep = false;
    m_moving[index].stillFor = 0;
    const Piece piece = m_moving[index].piece;
    const Entries state = piece.at(s);
    goOn(index, s, state, piece.mode,
         withVelocity(index, piece.mode, state, group.weights[k].velocity), piece.tied, true);
    if (m_diverged) return;
  }
  for (const int i : moved) schedule(i);
}

Entries Engine::withVelocity(int index, Mode mode, const Entries& state,
                             const Eigen::Vector2d& velocity) const {
  Entries result = state;
  if (isTethered(mode)) {
    result[2] = velocity.dot(trackOf(state)) / m_bodies[index].length;
  } else {
    result.segment<2>(2) = velocity.transpose();
  }
  return result;
}

bool Engine::isSupported(int index) const {
  const Piece& piece = m_moving[index].piece;
  return piece.settled || piece.mode == Mode::kSlide || piece.mode == Mode::kHeld;
}

void Engine::loseQuietly(double s, double impacts, double friction) {
  if (impacts == 0 && friction == 0) return;
  m_now.losses.impacts += impacts;
  m_now.losses.friction += friction;
  m_quietLosses.push_back({s, {impacts, 0, friction}});
}

}  // namespace core
