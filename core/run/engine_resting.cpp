#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/contact/impulse.h"
#include "core/run/engine.h"
#include "core/run/group.h"

// Weights in lasting contact move in groups, by time-stepping: every so often the forces
// that keep them apart are found together, and in between each keeps its velocity. First
// order, but nothing overlaps, nothing stalls, and energy only falls: core/model.md, "Rest".

namespace core {
namespace {

// Forces in groups are found anew this often [1/s].
constexpr double kSolvesPerSecond = 240;
// Approaches are found to this share of the group's highest speed, within these bounds:
// 3·10⁻⁵ m/s makes a gap of 0.1 µm in a stretch. What the sweeps leave undone, the next
// stretch goes on with.
constexpr double kShare = 1e-4;
constexpr double kFinest = 1e-6;
constexpr double kCoarsest = 3e-5;
constexpr int kMostSweeps = 1200;
constexpr int kLeastSweeps = 60;
// Sweeps for a given accuracy grow with the depth of a heap: those of more weights than this are
// solved more loosely, once more as loosely for every so many more, but not more than ten times.
constexpr double kExactlySolved = 200;
constexpr double kLooserEvery = 100;
constexpr double kLoosest = 10;
constexpr double kMostSkin = kSkin * kLoosest;  // [m]

// A group falls asleep when all its weights have been slower than this share of √(2 g r)
// for this many times √(2 r / g), the time in which what stands on a point leaves it by a
// factor of e: one that sets out to roll off another from 10⁻⁸ r off its top is faster by
// then.
constexpr double kStillSpeed = 1e-3;
constexpr double kStillTimes = 13;

/// The velocity air alone leaves a weight after a while: v/(1 + q |v| t).
Eigen::Vector2d slowedByAir(const Body& body, const Eigen::Vector2d& velocity, double duration) {
  return velocity / (1 + body.drag * velocity.norm() * duration);
}

/// What that takes [J].
double lostToAir(const Body& body, const Eigen::Vector2d& velocity, double duration) {
  const Eigen::Vector2d slowed = slowedByAir(body, velocity, duration);
  return 0.5 * body.mass * (velocity.squaredNorm() - slowed.squaredNorm());
}

}  // namespace

double Engine::looseness() const {
  return std::clamp(1 + (m_settledCount - kExactlySolved) / kLooserEvery, 1.0, kLoosest);
}

double Engine::skin() const {
  return kSkin * looseness();
}

int Engine::mostSweeps() const {
  return std::max(kLeastSweeps, static_cast<int>(kMostSweeps / looseness()));
}

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
    const Eigen::Vector2d margin =
        Eigen::Vector2d::Constant(m_bodies[index].radius + 2 * kMostSkin);
    m_broadPhase.forEachNear({place - margin, place + margin}, [&](int other) {
      Moving& moving = m_moving[other];
      if (!moving.asleep) return;
      const Eigen::Vector2d there =
          positionOf(m_bodies[other], moving.piece.mode, moving.piece.beginState);
      const double touching = m_bodies[index].radius + m_bodies[other].radius + 2 * kMostSkin;
      if ((there - place).squaredNorm() > touching * touching) return;
      moving.asleep = false;  // and again asleep after the solve, if that does not move it
      open.push_back(other);
    });
  }
  std::ranges::sort(members);
  return members;
}

void Engine::settle(double s, bool foresee) {
  m_solvedAt = s;
  std::vector<int> members = wakeTouching();
  m_settledCount = static_cast<int>(members.size());
  m_fastestSettled = 0;
  for (const int i : members) m_fastestSettled = std::max(m_fastestSettled, rateOf(i, s).norm());
  if (members.empty()) return;
  // A weight whose rope is nearly jammed: as in hitGroup().
  for (const bool bends : {true, false}) {
    Group group(*this, s, boundaryAfter(s) - s, true);
    for (const int i : members) group.add(i);
    if (!bends) group.straighten();
    const double pulled = findForces(group, s);
    const double lost = pushLoss(group.contacts, group.unkicked, group.weights);
    if (bends && lost < -kBought * group.kineticEnergyBefore() - pulled) {
      members = group.members;
      continue;
    }
    letGo(group, s);
    loseQuietly(s, std::max(0.0, pushLoss(group.contacts, group.unkicked, group.weights)),
                std::max(0.0, dragLoss(group.contacts, group.unkicked, group.weights)));
    loseQuietly(s, group.stopUnsolved(), 0);
    carryImpulses(group);
    fallAsleep(group, s);
    return goOnInGroup(group, s, foresee);
  }
}

/// Finds what keeps the members apart in the stretch.
/// @return  the kinetic energy that gravity and air would give them, if they were at rest [J]
double Engine::findForces(Group& group, double s) {
  // Those found within reach may be pushed as well, asleep or not, and need their contacts.
  int known = 0;
  const auto expand = [&] {
    for (; known < group.size(); ++known) {
      Moving& moving = m_moving[group.members[known]];
      moving.asleep = false;
      moving.untold.setZero();
      group.expand(known);
    }
  };
  expand();
  const double pulled = pull(group, s);
  warmStart(group);
  const ContactGoal goal{std::clamp(kShare * m_fastestSettled, kFinest, kCoarsest * looseness()),
                         mostSweeps()};
  group.solve(goal);
  while (known < group.size()) {  // it has brought in others
    expand();
    group.solve(goal);
  }
  return pulled;
}

/// Gives the group what weight and air do in the stretch.
/// @return  the kinetic energy of that alone [J]
double Engine::pull(Group& group, double s) {
  double energy = 0;
  for (std::size_t k = 0; k < group.members.size(); ++k) {
    const Piece& piece = m_moving[group.members[k]].piece;
    const Body& body = m_bodies[group.members[k]];
    RestingWeight& weight = group.weights[k];
    const Entries state = withVelocity(group.members[k], piece.mode, piece.at(s), {0, 0});
    const Entries slope = m_stepper.slope(body, piece.mode, state);
    const Eigen::Vector2d fallen =
        group.duration() * (isTethered(piece.mode)
                                ? Eigen::Vector2d(body.length * slope[2] * trackOf(state))
                                : Eigen::Vector2d(slope[2], slope[3]));
    const Eigen::Vector2d slowed = slowedByAir(body, weight.velocity, group.duration());
    energy += core::kineticEnergy({slowed + fallen - weight.velocity, body.mass});
    weight.velocity = slowed + fallen;
  }
  return energy;
}

/// Starts from the impulses of the stretch before: what lies goes on being pushed alike. What has
/// come away since does not: two walls that once pushed a weight against each other would take it
/// back and forth.
void Engine::warmStart(Group& group) const {
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    RestingContact& contact = group.contacts[i];
    if (contact.gap > skin()) continue;
    const std::pair key(group.members[contact.a], group.keys[i]);
    const auto carried = std::ranges::lower_bound(
        m_now.contacts, key, {}, [](const CarriedContact& c) { return std::pair(c.a, c.b); });
    const bool found = carried != m_now.contacts.end() && std::pair(carried->a, carried->b) == key;
    if (!found) continue;
    contact.push = carried->push;
    contact.drag = carried->drag;
  }
  applyCarried(group.weights, group.contacts);
}

/// Weights that nothing pushes leave the group, and so do those that lie on the floor with
/// nothing else that pushes them: they slide.
void Engine::letGo(Group& group, double s) {
  group.findSupport();
  double lost = 0;
  for (std::size_t k = 0; k < group.members.size(); ++k) {
    if (group.support[k] == Support::kOthers) continue;
    group.weights[k].velocity = group.unkicked[k];
    if (group.support[k] == Support::kNone) continue;
    const WallImpact impact =
        wallImpact(group.unkicked[k], group.weights[k].mass, {0, 1}, 0, m_scene->room.friction);
    group.weights[k].velocity = {impact.velocity.x(), 0};
    lost += impact.energyLost;
  }
  loseQuietly(s, lost, 0);
  for (RestingContact& contact : group.contacts)
    if (group.support[contact.a] == Support::kFloor) contact.push = contact.drag = 0;
  loseQuietly(s, endApproaches(group), 0);
}

/// Weights that leave with a slow approach to neighbours within the skin would be back at once: a
/// lean, though nothing presses them. Those approaches end here, without bounce. Weights that stay
/// do not give way: others lean on them.
/// @return  the energy that takes [J]
double Engine::endApproaches(Group& group) const {
  const auto leaves = [&](int k) { return k >= 0 && group.support[k] != Support::kOthers; };
  std::vector<RestingWeight> weights = group.weights;
  for (int k = 0; k < group.size(); ++k)
    if (!leaves(k)) weights[k].mass = INFINITY;
  std::vector<RestingContact> narrow;
  double fastest = 0;
  for (const RestingContact& contact : group.contacts) {
    if (contact.gap > 0 || (!leaves(contact.a) && !leaves(contact.b))) continue;
    Eigen::Vector2d closing = -weights[contact.a].velocity;
    if (contact.b >= 0) closing += weights[contact.b].velocity;
    fastest = std::max(fastest, closing.dot(contact.normal));
    narrow.push_back({.a = contact.a, .b = contact.b, .normal = contact.normal});
  }
  if (fastest <= m_tolerance.speed || fastest > slowestHit()) return 0;
  solveContacts(weights, narrow, 1, {m_tolerance.speed, mostSweeps()});
  double taken = 0;
  for (int k = 0; k < group.size(); ++k)
    if (leaves(k)) taken += kineticEnergy(group.weights[k]) - kineticEnergy(weights[k]);
  if (taken < 0) return 0;  // those that stay would drive them
  for (int k = 0; k < group.size(); ++k)
    if (leaves(k)) group.weights[k].velocity = weights[k].velocity;
  return taken;
}

double Engine::slowestHit() const {
  return 2 * m_scene->gravity * boundaryAfter(0);
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

void Engine::fallAsleep(const Group& group, double s) {
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
    const bool leans = group.support[k] == Support::kOthers;
    moving.stillFor = still && leans ? moving.stillFor + group.duration() : 0;
    if (!(moving.stillFor * moving.stillFor * gravity > kStillTimes * kStillTimes * size))
      mayRest[root(k)] = 0;
  }
  double lost = 0;
  for (int k = 0; k < static_cast<int>(group.members.size()); ++k) {
    m_moving[group.members[k]].asleep = mayRest[root(k)];
    if (mayRest[root(k)]) lost += kineticEnergy(group.weights[k]);
  }
  loseQuietly(s, lost, 0);
}

void Engine::goOnInGroup(const Group& group, double s, bool foresee) {
  for (std::size_t k = 0; k < group.members.size(); ++k) {
    const int index = group.members[k];
    const Piece piece = m_moving[index].piece;
    const Entries before = piece.at(s);
    const bool lies = group.support[k] == Support::kFloor;
    const bool stays = group.support[k] == Support::kOthers;
    m_moving[index].asleep = m_moving[index].asleep && stays;
    Eigen::Vector2d velocity = group.weights[k].velocity;
    if (m_moving[index].asleep) velocity.setZero();
    Entries after = withVelocity(index, piece.mode, before, velocity);
    if (lies) after[1] = m_bodies[index].radius;
    if (stays) after[4] += lostToAir(m_bodies[index], group.unkicked[k], group.duration());
    goOn(index, s, before, lies ? Mode::kSlide : piece.mode, after, piece.tied, stays);
    if (m_diverged) return;
  }
  if (!foresee) return;
  for (const int i : group.members) schedule(i);
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
