#include "ui/control/lanes.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace ui {

Lanes::Lanes(const std::shared_ptr<const core::Scene>& scene, StepTaker* steps) : m_steps(steps) {
  for (const core::Solver& solver : scene->solvers) {
    m_lanes.push_back(std::make_unique<Lane>(scene, solver));
    m_runs.push_back(&m_lanes.back()->run());
  }
  m_separations.start(m_runs);
}

void Lanes::follow(int weight) {
  for (const auto& lane : m_lanes) lane->follow(weight);
}

const Lane* Lanes::firstThatGoesOn() const {
  const auto first =
      std::ranges::find_if(m_lanes, &Lane::goesOn, &std::unique_ptr<Lane>::operator*);
  return first == m_lanes.end() ? nullptr : first->get();
}

bool Lanes::canCut() const {
  return std::ranges::any_of(m_lanes, [](const auto& lane) { return lane->canCut(); });
}

void Lanes::cutAll() {
  m_steps->giveUp();
  double moment = 0;
  for (const auto& lane : m_lanes) {
    if (lane->goesOn()) moment = std::max(moment, lane->run().time());
  }
  for (const auto& lane : m_lanes) {
    if (lane->canCut()) lane->cutAt(moment);
  }
  m_separations.dropAfter(moment);
}

/// The lane with the earliest time, of those that have to go on to reach `target`.
Lane* Lanes::furthestBehind(double target) {
  Lane* furthest = nullptr;
  for (const auto& lane : m_lanes) {
    if (!lane->goesOn() || lane->run().time() >= target) continue;
    if (!furthest || lane->run().time() < furthest->run().time()) furthest = lane.get();
  }
  return furthest;
}

void Lanes::advanceTo(double target, const GoOn& goOn) {
  while (Lane* lane = furthestBehind(target)) {
    if (!m_steps->take(*lane, Lane::Step::kOnwards)) return;
    m_separations.note(m_runs);
    if (!goOn(*lane)) return;
  }
}

double Lanes::timeReached(double target) const {
  double earliest = std::numeric_limits<double>::infinity();
  double last = 0;
  for (const auto& lane : m_lanes) {
    if (lane->goesOn()) earliest = std::min(earliest, lane->run().time());
    last = std::max(last, lane->run().time());
  }
  return std::min(target, canGoOn() ? earliest : last);
}

double Lanes::recordedUntil() const {
  double earliest = std::numeric_limits<double>::infinity();
  double last = 0;
  for (const auto& lane : m_lanes) {
    const double end = lane->recordedUntil();
    if (!lane->isComplete()) earliest = std::min(earliest, end);
    last = std::max(last, end);
  }
  return std::min(earliest, last);
}

void Lanes::aimAt(double time) {
  m_steps->giveUp();
  for (const auto& lane : m_lanes) lane->aimAt(time);
}

bool Lanes::approach(const GoOn& goOn) {
  for (const auto& lane : m_lanes) {
    while (lane->stepsToGo() > 0) {
      if (!m_steps->take(*lane, Lane::Step::kTowardsAim)) return false;
      if (lane->stepsToGo() > 0 && !goOn(*lane)) return false;
    }
  }
  return true;
}

void Lanes::arrive() {
  for (const auto& lane : m_lanes) lane->arrive();
}

std::int64_t Lanes::stepsToGo() const {
  return std::accumulate(
      m_lanes.begin(), m_lanes.end(), std::int64_t{0},
      [](std::int64_t sum, const auto& lane) { return sum + lane->stepsToGo(); });
}

bool Lanes::isShorterByRecord(double time) const {
  return std::ranges::any_of(m_lanes,
                             [time](const auto& lane) { return lane->isShorterByRecord(time); });
}

}  // namespace ui
