#include "core/aim/cut_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

#include "core/aim/hit_search.h"

namespace core {
namespace {

constexpr int kFewestIntervals = 200;
constexpr int kMostIntervals = 20'000;
constexpr int kIntervalsPerSwing = 60;
/// Samples further apart are halved, as a share of the room's width.
constexpr double kSmooth = 0.01;
/// Unless they are as close in time as this [s]: the curve is that steep.
constexpr double kSteep = 1e-4;
/// A curve that turns by less does not turn [m].
constexpr double kFlat = 1e-9;
/// Of the work: what the rest does not need is for the even samples.
constexpr double kShareOfHanging = 0.1, kShareOfRefining = 0.3;

}  // namespace

CutSweep::CutSweep(const Scene& scene, const Solver& solver, const CutSweepQuestion& question)
    : m_scene(scene),
      m_solver(solver),
      m_question(question),
      m_finder(scene, solver, question.weight, question.longestWait) {}

/// Of the even samples [s].
double CutSweep::spacing() const {
  const double range = m_question.until - m_question.from;
  double spacing = range / kFewestIntervals;
  const auto& rope = m_scene.weights[m_question.weight].rope;
  if (rope && m_scene.gravity > 0) {
    const double swing = 2 * std::numbers::pi * std::sqrt(rope->length / m_scene.gravity);
    spacing = std::min(spacing, swing / kIntervalsPerSwing);
  }
  return std::max(spacing, range / kMostIntervals);
}

bool CutSweep::compute(const Progress& progress) {
  WorkMeter meter(1, progress);
  if (!m_finder.hangUntil(m_question.until, meter) || !meter.add(kShareOfHanging)) return false;
  return sampleEvenly(meter) && refineAll(meter) && sampleTurns(meter) && meter.add(0);
}

bool CutSweep::sample(double cutTime, WorkMeter& meter) {
  const auto landing = m_finder.landing(cutTime, meter);
  if (landing) m_landings.insert_or_assign(cutTime, *landing);
  return landing.has_value();
}

bool CutSweep::sampleEvenly(WorkMeter& meter) {
  const double from = m_question.from;
  const double until = std::min(m_question.until, m_finder.hungUntil());
  if (until < from) return true;
  const int intervals = std::max(1, static_cast<int>(std::ceil((until - from) / spacing())));
  constexpr std::size_t kMostPerInterval = 5, kMostBesides = 5000;
  m_most = kMostPerInterval * intervals + kMostBesides;
  for (int i = 0; i <= intervals; ++i) {
    const double time = i == intervals ? until : from + (until - from) * i / intervals;
    if (!sample(time, meter)) return false;
    if (!meter.add((1 - kShareOfHanging - kShareOfRefining) / (intervals + 1))) return false;
  }
  return true;
}

bool CutSweep::isTooWide(const Landing& a, const Landing& b) const {
  const double width = b.cutTime - a.cutTime;
  if (!areAlike(a, b)) return width > kSharpness;
  if (a.outcome != LandingOutcome::kLanded) return false;
  return width > kSteep && std::abs(b.place - a.place) > kSmooth * m_scene.room.width;
}

/// Halves gaps until none is too wide, the widest first.
bool CutSweep::refine(std::vector<Gap> gaps, WorkMeter& meter) {
  const auto keepWide = [&] {
    std::erase_if(gaps, [&](const Gap& gap) {
      return !isTooWide(m_landings.at(gap.from), m_landings.at(gap.to));
    });
  };
  for (keepWide(); !gaps.empty(); keepWide()) {
    m_isResolved = m_landings.size() + gaps.size() <= m_most;
    if (!m_isResolved) return true;
    std::vector<Gap> halves;
    for (const Gap& gap : gaps) {
      const double middle = std::midpoint(gap.from, gap.to);
      if (middle <= gap.from || middle >= gap.to) continue;
      if (!sample(middle, meter)) return false;
      if (!meter.add(kShareOfRefining / static_cast<double>(m_most))) return false;
      halves.push_back({gap.from, middle});
      halves.push_back({middle, gap.to});
    }
    gaps = std::move(halves);
  }
  return true;
}

bool CutSweep::refineAll(WorkMeter& meter) {
  std::vector<Gap> gaps;
  for (auto landing = m_landings.begin(); landing != m_landings.end(); ++landing) {
    const auto next = std::next(landing);
    if (next != m_landings.end()) gaps.push_back({landing->first, next->first});
  }
  return refine(std::move(gaps), meter);
}

bool CutSweep::sampleTurns(WorkMeter& meter) {
  const std::vector<Landing> all = landings();
  for (std::size_t i = 1; i + 1 < all.size(); ++i) {
    const Landing &before = all[i - 1], &here = all[i], &after = all[i + 1];
    if (here.outcome != LandingOutcome::kLanded) continue;
    if (!areAlike(before, here) || !areAlike(here, after)) continue;
    const double rise = here.place - before.place, next = after.place - here.place;
    const bool turns = rise * next < 0 && std::max(std::abs(rise), std::abs(next)) > kFlat;
    if (turns && !sampleTurn(before, here, after, meter)) return false;
  }
  return true;
}

/// By golden sections between the outer two.
bool CutSweep::sampleTurn(const Landing& a, const Landing& b, const Landing& c, WorkMeter& meter) {
  constexpr double kGolden = 0.3819660112501051;
  const double up = b.place > a.place ? 1 : -1;
  double low = a.cutTime, high = c.cutTime;
  Landing best = b;
  while (high - low > kSharpness) {
    const bool isRight = high - best.cutTime > best.cutTime - low;
    const double tried =
        best.cutTime + kGolden * (isRight ? high - best.cutTime : low - best.cutTime);
    if (tried == best.cutTime) break;
    const auto landing = m_finder.landing(tried, meter);
    if (!landing) return false;
    if (!areAlike(*landing, b)) {
      m_landings.insert_or_assign(tried, *landing);
      std::array times{a.cutTime, tried, b.cutTime, c.cutTime};
      std::ranges::sort(times);
      return refine({{times[0], times[1]}, {times[1], times[2]}, {times[2], times[3]}}, meter);
    }
    const bool isBetter = up * landing->place > up * best.place;
    ((isBetter == isRight) ? low : high) = isBetter ? best.cutTime : tried;
    if (isBetter) best = *landing;
  }
  m_landings.insert_or_assign(best.cutTime, best);
  return true;
}

std::vector<Landing> CutSweep::landings() const {
  std::vector<Landing> landings;
  for (const auto& [time, landing] : m_landings) landings.push_back(landing);
  return landings;
}

std::optional<std::vector<Hit>> CutSweep::hitsOn(const Target& target, const Progress& progress) {
  constexpr int kMostRounds = 5;
  WorkMeter meter(1, progress);
  for (int round = 1;; ++round) {
    if (!refineAll(meter)) return std::nullopt;
    HitSearch search(m_finder, target, kSharpness, meter);
    if (!search.lookThrough(landings())) return std::nullopt;
    if (search.surprises().empty() || round == kMostRounds) return search.hits();
    // Between two samples something else was hit, after all.
    for (const Landing& landing : search.surprises())
      m_landings.insert_or_assign(landing.cutTime, landing);
  }
}

}  // namespace core
