#include "tests/support/run_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/scene/scene_limits.h"

namespace tests {
namespace {

using core::Energies;
using core::numberText;
using Eigen::Vector2d;

constexpr auto kLosses = {&Energies::lostToAir, &Energies::lostToImpacts, &Energies::lostToRopes,
                          &Energies::lostToFriction};

std::vector<Vector2d> placesAt(const core::Run& run, double time) {
  std::vector<Vector2d> places;
  for (int i = 0; i < run.weightCount(); ++i) places.push_back(run.weightAt(i, time).position);
  return places;
}

std::vector<Vector2d> placesNow(const core::Run& run) {
  std::vector<Vector2d> places;
  for (int i = 0; i < run.weightCount(); ++i) places.push_back(run.weight(i).position);
  return places;
}

double outside(const core::Scene& scene, const std::vector<Vector2d>& places,
               const Bounds& bounds) {
  const Vector2d room(scene.room.width, scene.room.height);
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double nearest = places[i].cwiseMin(room - places[i]).minCoeff();
    farthest = std::max(farthest, (1 - bounds.outsideShare) * scene.weights[i].radius - nearest);
  }
  return farthest;
}

/// Beyond what the bounds allow.
double overlap(const core::Scene& scene, const std::vector<Vector2d>& places,
               const Bounds& bounds) {
  double deepest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double radii = scene.weights[i].radius + scene.weights[j].radius;
      const double allowed = std::max(bounds.overlap, bounds.overlapShare * radii);
      deepest = std::max(deepest, radii - (places[i] - places[j]).norm() - allowed);
    }
  return deepest;
}

/// The largest of the entries that the ledger adds up [J].
double largestEntry(const Energies& energies, double start) {
  double largest = std::max({std::abs(energies.kinetic), std::abs(energies.potential), start});
  for (const auto loss : kLosses) largest = std::max(largest, std::abs(energies.*loss));
  return largest;
}

}  // namespace

Bounds Bounds::extreme(const core::Room& room) {
  return {.outside = 1e-6 + 1e-11 * std::max(room.width, room.height),
          .outsideShare = 1e-4,
          .overlap = 1e-6,
          .overlapShare = 0.01,
          .travelShare = 1e-14,
          .looksInside = false};
}

double farthestOutside(const core::Run& run, const Bounds& bounds) {
  return outside(run.scene(), placesNow(run), bounds);
}

double deepestOverlap(const core::Run& run, const Bounds& bounds) {
  return overlap(run.scene(), placesNow(run), bounds);
}

bool isFinite(const core::Run& run) {
  for (int i = 0; i < run.weightCount(); ++i) {
    const core::WeightState state = run.weight(i);
    if (!state.position.allFinite() || !state.velocity.allFinite()) return false;
    if (!std::isfinite(state.angle) || !std::isfinite(state.angularVelocity)) return false;
    if (!std::isfinite(state.tension)) return false;
  }
  const Energies energies = run.energies();
  return std::isfinite(energies.accounted()) && std::isfinite(energies.numericalDrift);
}

RunWatch::RunWatch(const core::Run& run, const Bounds& bounds)
    : m_bounds(bounds), m_time(run.time()), m_energies(run.energies()) {}

std::string RunWatch::faultAfterStep(const core::Run& run) {
  if (!isFinite(run)) return "numbers that are not finite";
  for (const core::Event& event : run.stepEvents())
    m_fastest = std::max({m_fastest, event.speedBefore, event.speedAfter});
  std::string fault = faultInPlaces(run);
  if (fault.empty()) fault = faultInLedger(run);
  if (fault.empty()) fault = faultInEvents(run);
  m_time = run.time();
  m_energies = run.energies();
  m_eventCount += run.stepEvents().size();
  return fault;
}

double RunWatch::roundingOfPlaces(const core::Run& run) const {
  double fastest = m_fastest;
  for (int i = 0; i < run.weightCount(); ++i)
    fastest = std::max(fastest, run.weight(i).velocity.norm());
  return m_bounds.travelShare * fastest * run.solver().step;
}

std::string RunWatch::faultInPlaces(const core::Run& run) const {
  const double rounding = roundingOfPlaces(run);
  const auto faultIn = [&](const std::vector<Vector2d>& places, double time) -> std::string {
    const std::string moment = " at " + numberText(time) + " s";
    const double out = outside(run.scene(), places, m_bounds);
    if (!(out <= m_bounds.outside + rounding))
      return numberText(out) + " m outside the room" + moment;
    const double deep = overlap(run.scene(), places, m_bounds);
    if (!(deep <= rounding)) return numberText(deep) + " m of overlap too much" + moment;
    return {};
  };
  std::string fault = faultIn(placesNow(run), run.time());
  if (!m_bounds.looksInside) return fault;
  for (double share = 0.125; share < 1 && fault.empty(); share += 0.25) {
    const double time = m_time + share * (run.time() - m_time);
    fault = faultIn(placesAt(run, time), time);
  }
  return fault;
}

std::string RunWatch::faultInLedger(const core::Run& run) const {
  const Energies now = run.energies();
  const double open = now.accounted() - run.startEnergy() - now.numericalDrift;
  // Sums of seven numbers, in two orders.
  constexpr double kRounding = 1e-14;
  if (std::abs(open) > kRounding * largestEntry(now, std::abs(run.startEnergy())))
    return "a ledger open by " + numberText(open) + " J";
  for (const auto loss : kLosses)
    if (now.*loss < m_energies.*loss) return "a loss that shrank to " + numberText(now.*loss);
  return {};
}

std::string RunWatch::faultInEvents(const core::Run& run) const {
  // Moments count from the start of their step and are rounded where time is added.
  const double rounding = 1e-15 * run.time();
  double latest = m_time - rounding;
  for (const core::Event& event : run.stepEvents()) {
    if (!(event.time >= latest) || !(event.time <= run.time() + rounding))
      return "an event out of order at " + numberText(event.time) + " s";
    latest = event.time;
    if (!(event.energyLost >= 0)) return "an event that gains " + numberText(-event.energyLost);
    if (event.weight >= run.weightCount() || event.other >= run.weightCount())
      return "an event of a weight that is not there";
    if (!event.position.allFinite() || !std::isfinite(event.speedBefore + event.speedAfter))
      return "an event that is not finite";
  }
  return {};
}

}  // namespace tests
