#include "core/aim/landing_history.h"

#include <set>

namespace core {
namespace {

FirstHit hitIn(const Event& event) {
  switch (event.kind) {
    case EventKind::kImpactWest:
    case EventKind::kImpactEast:
    case EventKind::kImpactCeiling:
      return FirstHit::kWall;
    case EventKind::kImpactWeight:
      return FirstHit::kWeight;
    default:
      return FirstHit::kNothing;
  }
}

/// One step of the FNV-1a hash.
std::uint64_t mixed(std::uint64_t hash, int number) {
  constexpr std::uint64_t kPrime = 0x100000001b3;
  return (hash ^ static_cast<std::uint32_t>(number)) * kPrime;
}

}  // namespace

bool mayMatter(const Event& event) {
  switch (event.kind) {
    case EventKind::kTurningPoint:
    case EventKind::kSlack:
    case EventKind::kRest:
      return false;
    default:
      return true;
  }
}

void LandingHistory::add(const Event& event) {
  if (!mayMatter(event)) return;
  m_events.push_back(event);
  const bool isOwn = event.weight == m_weight || event.other == m_weight;
  if (m_isCut && isOwn && m_firstHit == FirstHit::kNothing) m_firstHit = hitIn(event);
  if (event.kind == EventKind::kCut) m_isCut = true;
}

bool LandingHistory::isLanding(const Event& event) const {
  return m_isCut && event.weight == m_weight && event.kind == EventKind::kImpactFloor;
}

std::uint64_t LandingHistory::mark() const {
  constexpr std::uint64_t kStart = 0xcbf29ce484222325;
  std::uint64_t hash = kStart;
  std::set<int> involved{m_weight};
  for (auto latest = m_events.rbegin(); latest != m_events.rend(); ++latest) {
    const Event& event = *latest;
    const bool isOfAll = event.kind == EventKind::kCut;
    if (!isOfAll && !involved.contains(event.weight) && !involved.contains(event.other)) continue;
    if (event.kind == EventKind::kImpactWeight) involved.insert({event.weight, event.other});
    hash = mixed(mixed(mixed(hash, static_cast<int>(event.kind)), event.weight), event.other);
  }
  return hash;
}

}  // namespace core
