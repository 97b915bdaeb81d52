#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/run/run.h"
#include "tests/bench/peers/discs.h"
#include "tests/bench/peers/rounds.h"
#include "tests/bench/peers/rows.h"
#include "tests/bench/peers/table.h"
#include "tests/support/billiard.h"

namespace bench {
namespace {

constexpr int kBounces = 10;
constexpr double kHeight = 1;  // the ball falls [m]
constexpr double kStep = 1.0 / 60;
constexpr int kBallSteps = 240;  // the tenth bounce is at 3.6 s

core::Scene ball() {
  core::Scene scene;
  scene.airDensity = 0;
  scene.restitution = scene.room.restitution = 0.8;
  core::Weight weight;
  weight.position = {2, kHeight + weight.radius};
  scene.weights.push_back(weight);
  return scene;
}

/// Largest error of the bounce times [s]; infinite if some are missing.
double worstError(const core::Scene& scene, const std::vector<double>& times) {
  if (times.size() < kBounces) return INFINITY;
  double exact = std::sqrt(2 * kHeight / scene.gravity), worst = 0;
  double speed = scene.gravity * exact;
  for (int i = 0; i < kBounces; ++i) {
    worst = std::max(worst, std::abs(times[i] - exact));
    speed *= scene.restitution;
    exact += 2 * speed / scene.gravity;
  }
  return worst;
}

std::vector<double> ourBounces(const core::Scene& scene) {
  core::Run run(std::make_shared<const core::Scene>(scene), {.method = "rk4", .step = kStep});
  std::vector<double> times;
  for (int i = 0; i < kBallSteps; ++i) {
    run.advance();
    for (const core::Event& event : run.stepEvents())
      if (event.kind == core::EventKind::kImpactFloor) times.push_back(event.time);
  }
  return times;
}

/// Read off the engine as kindly as may be: in a step that turned the ball, the moment at which
/// it would have come to the floor from where it was before.
std::vector<double> bouncesOf(const core::Scene& scene, DiscWorld& world) {
  std::vector<double> times;
  const double g = scene.gravity;
  for (int i = 0; i < kBallSteps; ++i) {
    const double down = -world.velocity(0).y();
    const double gap = std::max(0.0, world.position(0).y() - scene.weights[0].radius);
    world.step();
    if (down <= 0 || world.velocity(0).y() <= 0) continue;
    const double fall = (std::sqrt(down * down + 2 * g * gap) - down) / g;
    times.push_back(i * kStep + std::min(fall, kStep));
  }
  return times;
}

void stepBall(MakeWorld make, const WorldOptions& options) {
  const core::Scene scene = ball();
  const auto world = make(scene, options);
  for (int i = 0; i < kBallSteps; ++i) world->step();
}

void printBallRow() {
  const core::Scene scene = ball();
  const double ours = worstError(scene, ourBounces(scene));
  WorldOptions options{.mayRest = false};
  std::vector<Contender> contenders{{"ours", [&] { stepBall(ourWorld, options); }}};
  const std::vector<Engine> engines = otherEngines();
  std::vector<double> errors;
  for (const Engine& engine : engines) {
    const auto world = engine.make(scene, options);
    errors.push_back(worstError(scene, bouncesOf(scene, *world)));
    contenders.push_back({engine.name, [&] { stepBall(engine.make, options); }});
  }
  const std::vector<Timing> timings = timed(contenders);
  Row row{.work = "ball bounces, e = 0.8, steps of 1/60 s: worst of ten bounce times; a step",
          .ours = duration(ours) + "; " + duration(timings[0].time / kBallSteps),
          .aim = "≥ 1000×"};
  if (!engines.empty()) {
    const auto best = std::ranges::min_element(errors) - errors.begin();
    row.peer = duration(errors[best]) + "; " + duration(timings[best + 1].time / kBallSteps) +
               ", " + engines[best].name;
    row.ratio = times(errors[best] / ours);
    row.isReached = errors[best] >= 1000 * ours;
  }
  print(row);
}

constexpr double kMassRatio = 1e6;
constexpr int kImpacts = 3141;

struct BilliardFigures {
  int impacts;
  double error;  // of the heavy disc's place at the end [m]
};

BilliardFigures playBilliard(MakeWorld make, double step) {
  const core::Scene scene = tests::billiard(kMassRatio);
  const auto world = make(scene, {.step = step, .mayRest = false});
  const auto steps = std::llround(tests::kBilliardEnd / step);
  for (std::int64_t i = 0; i < steps; ++i) world->step();
  const double exact = tests::exactBilliardPlace(scene, static_cast<double>(steps) * step);
  return {world->impacts(), std::abs(world->position(1).x() - exact)};
}

/// The longest of steps ten times apart with which the engine counts right; 0: none does.
double stepToCount(const Engine& engine) {
  for (const double step : {1e-2, 1e-3, 1e-4, 1e-5})
    if (playBilliard(engine.make, step).impacts == kImpacts) return step;
  return 0;
}

void printBilliardRow() {
  BilliardFigures ours{};
  std::vector<Contender> contenders{{"ours", [&] { ours = playBilliard(ourWorld, kStep); }}};
  std::vector<std::pair<Engine, double>> counting;
  for (const Engine& engine : otherEngines())
    if (const double step = stepToCount(engine); step > 0) counting.push_back({engine, step});
  for (const auto& [engine, step] : counting)
    contenders.push_back(
        {engine.name, [make = engine.make, step = step] { playBilliard(make, step); }});
  const std::vector<Timing> timings = timedOnce(contenders, 3);
  Row row{.work = "Galperin's billiard, mass ratio 10^6: 3141 impacts counted; place; time",
          .ours = text("%d; off by %.1g m; ", ours.impacts, ours.error) + duration(timings[0].time),
          .aim = "right, 1e-10 m, ≥ 1×"};
  row.isReached = ours.impacts == kImpacts && ours.error <= 1e-10;
  if (!otherEngines().empty()) row.peer = "none counts right down to steps of 10^-5 s";
  if (!counting.empty()) {
    std::size_t best = 0;
    for (std::size_t i = 0; i < counting.size(); ++i)
      if (timings[i + 1].time < timings[best + 1].time) best = i;
    const auto& [engine, step] = counting[best];
    row.peer = text("%d; off by %.1g m; ", kImpacts, playBilliard(engine.make, step).error) +
               duration(timings[best + 1].time) + ", " + engine.name + text(" (step %g s)", step);
    row.ratio = times(timings[best + 1].ratio);
    row.isReached = row.isReached && timings[best + 1].ratio >= 1;
  }
  print(row);
}

}  // namespace

void printContactRows() {
  printBallRow();
  printBilliardRow();
}

}  // namespace bench
