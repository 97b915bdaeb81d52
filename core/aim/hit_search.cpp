#include "core/aim/hit_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace core {
namespace {

constexpr double kRootWidth = 1e-10;  // [s]
constexpr double kRoot = 1e-13;       // so near to a line is on it [m]
/// What still lies between two cut times that close is a jump [m].
constexpr double kJump = 1e-4;
/// Nearer to the center by less is not nearer: of several roots the first is the best [m].
constexpr double kSame = 1e-9;

bool liesBetween(double line, const Landing& a, const Landing& b) {
  return (a.place < line && line < b.place) || (b.place < line && line < a.place);
}

}  // namespace

bool HitSearch::lookThrough(const std::vector<Landing>& landings) {
  for (std::size_t i = 0; i < landings.size() && m_goesOn; ++i) {
    const Landing& here = landings[i];
    const bool isOn = here.outcome == LandingOutcome::kLanded && m_target.holds(here.place);
    if (isOn && !m_open) open(here);
    if (m_open) consider(here);
    if (i + 1 == landings.size() || !areAlike(here, landings[i + 1])) {
      if (m_open) close(here);
    } else if (here.outcome == LandingOutcome::kLanded) {
      lookBetween(here, landings[i + 1]);
    }
  }
  return m_goesOn;
}

/// Both landings are alike, and the place changes one way between them.
void HitSearch::lookBetween(const Landing& a, const Landing& b) {
  const bool isEastward = a.place < b.place;
  std::vector<double> lines{m_target.west(), m_target.center, m_target.east()};
  if (!isEastward) std::ranges::reverse(lines);
  for (const double line : lines) {
    if (!liesBetween(line, a, b)) continue;
    const auto landing = crossing(a, b, line);
    if (!m_goesOn) return;
    if (landing) cross(*landing, line, isEastward);
  }
  if (m_open && !m_target.holds(b.place)) close(a);
  if (m_open && b.place == m_target.center && a.place != b.place)
    m_open->centers.push_back(b.cutTime);
}

void HitSearch::cross(const Landing& landing, double line, bool isEastward) {
  if (line == m_target.center) {
    if (!m_open || std::abs(landing.place - line) > kJump) return;
    m_open->centers.push_back(landing.cutTime);
    return consider(landing);
  }
  const bool isEntering = (line == m_target.west()) == isEastward;
  if (isEntering && !m_open) open(landing);
  if (!isEntering && m_open) close(landing);
}

/// Where the landing place is a line: by the Illinois method, with bisections between that keep
/// it from crawling. Nothing where a landing between is unlike both.
std::optional<Landing> HitSearch::crossing(Landing a, Landing b, double place) {
  double offA = a.place - place, offB = b.place - place;
  int movedBefore = 0;  // −1: the first end, 1: the second
  for (int i = 1; b.cutTime - a.cutTime > kRootWidth; ++i) {
    const double middle = std::midpoint(a.cutTime, b.cutTime);
    double tried = i % 3 == 0 ? middle : (a.cutTime * offB - b.cutTime * offA) / (offB - offA);
    if (!(a.cutTime < tried && tried < b.cutTime)) tried = middle;
    if (!(a.cutTime < tried && tried < b.cutTime)) break;
    const auto landing = m_finder.landing(tried, m_meter);
    m_goesOn = landing.has_value();
    if (!m_goesOn) return std::nullopt;
    if (!areAlike(*landing, a)) {
      m_surprises.push_back(*landing);
      return std::nullopt;
    }
    const double off = landing->place - place;
    if (std::abs(off) <= kRoot) return landing;
    const int moved = (off < 0) == (offA < 0) ? -1 : 1;
    (moved < 0 ? a : b) = *landing;
    (moved < 0 ? offA : offB) = off;
    if (moved == movedBefore) (moved < 0 ? offB : offA) /= 2;
    movedBefore = moved;
  }
  return std::abs(a.place - place) < std::abs(b.place - place) ? a : b;
}

void HitSearch::open(const Landing& landing) {
  m_open.emplace();
  m_open->from = landing.cutTime;
  m_open->offCenter = std::numeric_limits<double>::infinity();
  m_open->firstHit = landing.firstHit;
  if (landing.place == m_target.center) m_open->centers.push_back(landing.cutTime);
  consider(landing);
}

void HitSearch::consider(const Landing& landing) {
  const double off = std::abs(landing.place - m_target.center);
  if (off >= m_open->offCenter - kSame) return;
  m_open->best = landing.cutTime;
  m_open->offCenter = off;
  m_open->landsAt = landing.time;
}

void HitSearch::close(const Landing& landing) {
  consider(landing);
  m_open->until = landing.cutTime;
  if (m_open->until - m_open->from >= 2 * m_sharpness) m_hits.push_back(*m_open);
  m_open.reset();
}

}  // namespace core
