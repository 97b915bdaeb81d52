#include <algorithm>
#include <cmath>

#include "core/run/engine.h"
#include "core/run/group.h"

// A hit on a weight of a group goes on through the group at once: core/model.md, "Rest".

namespace core {
namespace {

// After a hit, until the next solve, this is enough [m/s], or this share of the hit.
constexpr double kHitTolerance = 3e-5;
constexpr double kHitShare = 5e-5;
constexpr int kMostSweeps = 300;
// While a hit is still reaching others, so many sweeps carry it on.
constexpr int kSweepsPerRing = 2;

}  // namespace

void Engine::spread(double s, const std::vector<int>& seeds, double approach) {
  const double tolerance = std::max(kHitTolerance, kHitShare * approach);
  Group group(*this, s, std::max(boundaryAfter(s) - s, 1e-9));
  for (const int i : seeds) group.add(i);
  while (true) {
    if (expandHit(group, static_cast<int>(seeds.size()), tolerance)) {
      group.solve({tolerance, kSweepsPerRing});
      continue;
    }
    group.solve({tolerance, kMostSweeps});
    if (!expandHit(group, static_cast<int>(seeds.size()), tolerance)) break;
  }
  loseQuietly(s, inelasticLoss(group.contacts, group.unkicked, group.weights), 0);
  moveSpread(group, s);
}

bool Engine::expandHit(Group& group, int seeds, double tolerance) {
  bool reachesOthers = false;
  for (int local = 0, count = group.size(); local < count; ++local) {
    const double change = (group.weights[local].velocity - group.unkicked[local]).norm();
    if (group.isExpanded(local) || (local >= seeds && change <= tolerance)) continue;
    group.expand(local);
    reachesOthers = true;
  }
  return reachesOthers;
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

}  // namespace core
