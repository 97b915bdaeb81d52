#include <algorithm>
#include <cmath>

#include "core/run/engine.h"
#include "core/run/hit_wave.h"

// A hit on a weight of a group goes on through the group at once: core/model.md, "Rest".

namespace core {
namespace {

// Until the next solve a change of velocity that goes nowhere makes a gap of this at most [m].
constexpr double kHitGap = 3e-7;
// Where that is soon, a hit still goes on until its changes are this slow [m/s].
constexpr double kCoarsest = 1e-2;

}  // namespace

void Engine::hitGroup(int a, int b, double s, const Eigen::Vector2d& normal, double restitution,
                      const std::vector<int>& landing) {
  const double duration = std::max(stretchEnd(s) - s, 1e-9);
  const double tolerance = std::min(looseness() * kHitGap / duration, kCoarsest);
  const ContactGoal goal{tolerance, mostSweeps()};
  // A weight whose rope is nearly jammed between the others cannot give way along its circle: what
  // it drives off instead may gain more than there is. Then circles are left to stopUnsolved().
  for (const bool bends : {true, false}) {
    Group group(*this, s, duration, false);
    group.addHit(a, b, normal, restitution);
    if (!bends) group.straighten();
    HitWave(group, goal, duration).run();
    double lost = group.loss();
    if (lost < 0) {
      soften(group, goal, duration, restitution);
      lost = group.loss();
    }
    if (bends && lost < -kBought * group.kineticEnergyBefore()) continue;
    // Gaps that are too narrow are widened at some cost, and rounding may leave −10⁻¹⁵ of nothing.
    lost = std::max(0.0, lost);
    const double lostInHit =
        std::clamp(pushLoss({group.contacts.data(), 1}, group.unkicked, group.weights), 0.0, lost);
    loseQuietly(s, lost - lostInHit, 0);
    loseQuietly(s, group.stopUnsolved(), 0);
    if (group.contacts.front().push > 0) logHit(group, s, lostInHit, landing);
    return moveSpread(group, s);
  }
}

/// Weights that part from each other and are pushed together again by the hit may gain more than
/// it takes. Without restitution nothing ever gains. What becomes of the group lies between the
/// two, such that it loses the share 1 − e² of what it would lose without restitution: as two
/// alone do, and as all do whose contacts have that restitution together.
///
/// Source: Moreau, Unilateral contact and dry friction in finite freedom dynamics (1988), §9.
void Engine::soften(Group& group, const ContactGoal& goal, double duration, double restitution) {
  const std::vector<RestingContact> thrownContacts = group.contacts;
  const std::vector<RestingWeight> thrown = group.weights;
  group.undoHit();
  HitWave(group, goal, duration).run();
  const double most = restitution * restitution * std::max(0.0, group.loss());
  const auto change = [&](std::size_t k) -> Eigen::Vector2d {
    const Eigen::Vector2d& far = k < thrown.size() ? thrown[k].velocity : group.unkicked[k];
    return far - group.weights[k].velocity;
  };
  double slope = 0, curvature = 0;  // of the energy from here to there [J]
  for (std::size_t k = 0; k < group.weights.size(); ++k) {
    const RestingWeight& weight = group.weights[k];
    slope += weight.mass * weight.velocity.dot(change(k));
    curvature += weight.mass * change(k).squaredNorm();
  }
  if (curvature == 0) return;
  const double root = std::sqrt(slope * slope + 2 * curvature * most);
  const double share = std::clamp((root - slope) / curvature, 0.0, 1.0);
  for (std::size_t k = 0; k < group.weights.size(); ++k)
    group.weights[k].velocity += share * change(k);
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    RestingContact& contact = group.contacts[i];
    const bool isKnown = i < thrownContacts.size();
    contact.push += share * ((isKnown ? thrownContacts[i].push : 0) - contact.push);
    contact.drag += share * ((isKnown ? thrownContacts[i].drag : 0) - contact.drag);
  }
}

void Engine::logHit(const Group& group, double s, double lost, const std::vector<int>& landing) {
  const auto after = [&](int local) {
    const int index = group.members[local];
    const Piece& piece = m_moving[index].piece;
    const Entries state =
        withVelocity(index, piece.mode, piece.beginState, group.weights[local].velocity);
    return readOut(index, piece.mode, piece.tied, state);
  };
  const int a = group.members[0], b = group.members[1];
  const Piece& piece = m_moving[a].piece;
  log(EventKind::kImpactWeight, s, a, readOut(a, piece.mode, piece.tied, piece.beginState),
      after(0), lost, b);
  for (const int i : landing) {
    const WeightState there = after(i == a ? 0 : 1);
    log(EventKind::kRest, s, i, there, there, 0);
  }
}

void Engine::moveSpread(const Group& group, double s) {
  std::vector<int> moved;
  for (std::size_t k = 0; k < group.members.size(); ++k) {
    const int index = group.members[k];
    m_moving[index].untold.setZero();
    if (m_moving[index].piece.settled)
      m_moving[index].untold = group.weights[k].velocity - group.told[k];
    if (k >= 2 && group.weights[k].velocity == group.unkicked[k]) continue;
    moved.push_back(index);
    m_moving[index].asleep = false;
    m_moving[index].stillFor = 0;
    const Piece piece = m_moving[index].piece;
    const Entries state = piece.at(s);
    const Entries after = withVelocity(index, piece.mode, state, group.weights[k].velocity);
    goOn(index, s, state, modeAfterPush(piece.mode, after, piece.settled), after, piece.tied,
         piece.settled);
    if (m_diverged) return;
  }
  for (const int i : moved) schedule(i);
}

}  // namespace core
