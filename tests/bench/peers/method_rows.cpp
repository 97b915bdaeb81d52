#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/bench/peers/pendulum.h"
#include "tests/bench/peers/rounds.h"
#include "tests/bench/peers/rows.h"
#include "tests/bench/peers/table.h"

namespace bench {
namespace {

constexpr double kRelease = 120 * std::numbers::pi / 180;  // [rad]
constexpr Pendulum kInVacuum{.angle = kRelease, .drag = 0};
constexpr Pendulum kInAir{.angle = kRelease, .drag = 0.0226};

/// A solver at the coarsest setting that is good enough.
struct Candidate {
  const PendulumSolver* solver;
  double setting;
};

std::vector<Timing> timedOn(const Pendulum& pendulum, const std::vector<Candidate>& candidates) {
  std::vector<Contender> contenders;
  for (const Candidate& candidate : candidates)
    contenders.push_back({candidate.solver->name, [&pendulum, candidate] {
                            candidate.solver->solve(pendulum, candidate.setting, nullptr);
                          }});
  return timed(contenders);
}

const PendulumSolver* named(const std::vector<PendulumSolver>& all, const char* name) {
  for (const PendulumSolver& solver : all)
    if (solver.name == name) return &solver;
  return nullptr;
}

void printStepRow(const std::vector<PendulumSolver>& all) {
  constexpr double kRate = 60;
  std::vector<Candidate> candidates{{named(all, "rk4"), kRate}};
  const PendulumSolver* peer = named(all, "odeint rk4");
  if (peer) candidates.push_back({peer, kRate});
  const std::vector<Timing> timings = timedOn(kInVacuum, candidates);
  const double steps = kRate * kInVacuum.until;
  Row row{.work = "one pendulum, Runge–Kutta 4, a step",
          .ours = duration(timings[0].time / steps),
          .aim = "≥ 1×"};
  if (peer) {
    row.peer = duration(timings[1].time / steps) + ", odeint `array<double, 2>`";
    row.ratio = times(timings[1].ratio);
    row.isReached = timings[1].ratio >= 1;
  }
  print(row);
}

std::string cost(const Candidate& candidate, const Timing& timing, const Pendulum& pendulum) {
  const std::string setting = candidate.solver->takesTolerance
                                  ? text("tolerance %.1e", candidate.setting)
                                  : text("%.0f steps/s", candidate.setting);
  return duration(timing.time / pendulum.until) + ", " + candidate.solver->name + " (" + setting +
         ")";
}

/// Solvers that are right to `error`, at their cheapest; ours first.
std::vector<Candidate> candidatesFor(const std::vector<PendulumSolver>& all,
                                     const Pendulum& pendulum, double error,
                                     bool (*takes)(const PendulumSolver&)) {
  const ExactPendulum exact(pendulum);
  std::vector<Candidate> candidates;
  for (const PendulumSolver& solver : all) {
    if (!takes(solver)) continue;
    const double setting = settingFor(solver, pendulum, exact, error);
    if (setting > 0) candidates.push_back({&solver, setting});
  }
  return candidates;
}

/// The cheapest of those whose names start so; candidates.size() if there are none.
std::size_t cheapest(const std::vector<Candidate>& candidates, const std::vector<Timing>& timings,
                     bool isOurs, const std::string& start) {
  std::size_t best = candidates.size();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const PendulumSolver& solver = *candidates[i].solver;
    if (solver.isOurs != isOurs || !solver.name.starts_with(start)) continue;
    if (best == candidates.size() || timings[i].time < timings[best].time) best = i;
  }
  return best;
}

/// Whether that library was there when the program was built.
bool isThere(const std::string& other) {
  const std::vector<PendulumSolver> all = allSolvers();
  return std::ranges::any_of(
      all, [&](const PendulumSolver& solver) { return solver.name.starts_with(other); });
}

/// Best of ours beside the best of each of the others, per simulated second.
void printCostRows(const std::string& work, const Pendulum& pendulum,
                   const std::vector<Candidate>& candidates, const std::string& judgedBy) {
  const std::vector<Timing> timings = timedOn(pendulum, candidates);
  const std::size_t none = candidates.size(), ours = cheapest(candidates, timings, true, "");
  for (const char* other : {"odeint", "GSL"}) {
    if (!isThere(other)) continue;
    const std::size_t peer = cheapest(candidates, timings, false, other);
    const bool isJudged = judgedBy == other;
    Row row{.work = work,
            .ours = "not reached",
            .peer = std::string(other) + " does not get there",
            .aim = isJudged ? "≥ 1×" : "stated",
            .isReached = ours != none};
    if (ours != none) row.ours = cost(candidates[ours], timings[ours], pendulum);
    if (peer != none) row.peer = cost(candidates[peer], timings[peer], pendulum);
    if (ours != none && peer != none) {
      const double ratio = timings[peer].ratio / timings[ours].ratio;
      row.ratio = times(ratio);
      row.isReached = ratio >= 1;
    }
    print(row);
  }
}

}  // namespace

void printMethodRows() {
  const std::vector<PendulumSolver> all = allSolvers();
  printStepRow(all);
  const auto anyMethod = [](const PendulumSolver&) { return true; };
  for (const double error : {1e-6, 1e-9})
    printCostRows(
        text("pendulum, 120°, 10 s, right to 10^%.0f rad: a simulated second", std::log10(error)),
        kInVacuum, candidatesFor(all, kInVacuum, error, anyMethod), "odeint");
  const auto highOrder = [](const PendulumSolver& solver) {
    return solver.isOurs ? solver.name.starts_with("reference") : solver.name != "odeint rk4";
  };
  printCostRows("pendulum, 120°, 10 s, right to 10^-13 rad", kInVacuum,
                candidatesFor(all, kInVacuum, 1e-13, highOrder), "GSL");
  const auto wholeRun = [](const PendulumSolver& solver) {
    return solver.isOurs ? solver.name == "reference, whole run" : solver.name != "odeint rk4";
  };
  printCostRows("the same with drag", kInAir, candidatesFor(all, kInAir, 1e-13, wholeRun), "GSL");
}

}  // namespace bench
