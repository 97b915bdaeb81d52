#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/ui/files/figures_by_subject.h"
#include "tests/ui/files/measured_lesson.h"

namespace tests {
namespace {

using core::Event;
using core::EventKind;
using core::Run;
using core::Scene;
using Figures = std::vector<LessonFigure>;

constexpr int kFraction = LessonFigure::kFraction;
constexpr int kPower = LessonFigure::kPower;

double drift(const PlayedLesson& lesson) {
  return lesson.run().energies().numericalDrift;
}

/// The largest distance between the same weight in two runs of a scene, now [m].
double apart(const PlayedLesson& a, const PlayedLesson& b) {
  double farthest = 0;
  const double time = std::min(a.run().time(), b.run().time());
  for (int i = 0; i < a.run().weightCount(); ++i) {
    const Eigen::Vector2d gap =
        a.run().weightAt(i, time).position - b.run().weightAt(i, time).position;
    farthest = std::max(farthest, gap.norm());
  }
  return farthest;
}

Figures onePendulum() {
  const char* const name = "one-pendulum";
  const PlayedLesson rk4 = played(name, 0, 8), euler = played(name, 1, 8);
  const double cut = *rk4.scene().cutTime;
  const auto fine = [](Scene& scene) { scene.solvers[1].step = 1.0 / 600; };
  const PlayedLesson eulerAtCut = played(name, 1, cut);
  const Event& wall = rk4.first(EventKind::kImpactEast, 0);
  const Event& eulersWall = euler.first(EventKind::kImpactEast, 0);
  return {
      {"first turn", rk4.first(EventKind::kTurningPoint, 0).time, 3, "s"},
      {"its height", rk4.first(EventKind::kTurningPoint, 0).position.y(), 2, "m"},
      {"start's height", core::startPosition(rk4.scene().weights[0]).y(), 2, "m"},
      {"its height by Euler", euler.first(EventKind::kTurningPoint, 0).position.y(), 2, "m"},
      {"cut", cut, 1, "s"},
      {"Euler's drift", drift(eulerAtCut), 3, "J"},
      {"the same in percent", driftPercent(eulerAtCut), 1, "%"},
      {"the same with small steps", drift(played(changed(name, fine), 1, cut)), 3, "J"},
      {"Euler at the wall", eulersWall.time, 3, "s"},
      {"at the wall", wall.time, 3, "s"},
      {"how much lower", eulersWall.position.y() - wall.position.y(), 2, "m"},
      {"rest", rk4.first(EventKind::kRest, 0).time, 3, "s"},
      {"lost to impacts", rk4.run().energies().lostToImpacts, 2, "J"},
      {"energy", rk4.run().startEnergy(), 2, "J"},
      {"step", stepsPerSecond(rk4.scene(), 0), kFraction, "s"},
  };
}

Figures sevenWeights() {
  const char* const name = "seven-weights";
  PlayedLesson rk4(name), euler(name, 1), again(name);
  PlayedLesson fine(changed(name, [](Scene& scene) { scene.solvers[1].step = 1.0 / 120; }), 1);
  const auto apartAt = [](PlayedLesson& a, PlayedLesson& b, double time) {
    a.play(time);
    b.play(time);
    return apart(a, b);
  };
  const double cut = *rk4.scene().cutTime;
  Figures figures = {
      {"cut", cut, 1, "s"},
      {"apart at the cut", apartAt(rk4, euler, cut), 3, "m"},
      {"second moment", 2, 0, "s"},
      {"apart then", apartAt(rk4, euler, 2), 3, "m"},
      {"third moment", 2.5, 1, "s"},
      {"apart then", apartAt(rk4, euler, 2.5), 2, "m"},
      {"fourth moment", 3, 0, "s"},
      {"apart then, at least", std::floor(apartAt(rk4, euler, 3)), 0, "m"},
      {"apart with half the step", apartAt(again, fine, cut), 3, "m"},
      {"the same later", apartAt(again, fine, 2.5), 2, "m"},
  };
  rk4.play(8);
  euler.play(8);
  const auto first = std::ranges::find(rk4.events(), EventKind::kRest, &Event::kind);
  for (const LessonFigure& figure : Figures{
           {"rests first", first->weight + 1.0, 0, ""},
           {"rest", first->time, 2, "s"},
           {"last moment", 8, 0, "s"},
           {"lost to impacts", rk4.run().energies().lostToImpacts, 1, "J"},
           {"lost to air", rk4.run().energies().lostToAir, 2, "J"},
           {"energy", rk4.run().startEnergy(), 1, "J"},
           {"Euler's drift", drift(euler), 2, "J"},
           {"the same in percent", driftPercent(euler), 1, "%"},
           {"step", stepsPerSecond(rk4.scene(), 0), kFraction, "s"},
       })
    figures.push_back(figure);
  return figures;
}

/// When the weight is first beyond the top [s]; 0 if it never is.
double timeOverTheTop(PlayedLesson lesson, double until) {
  double over = 0;
  lesson.play(until, [&](const Run& run) {
    if (over == 0 && std::abs(run.weight(0).angle) > std::numbers::pi) over = run.time();
  });
  return over;
}

Figures eulerGainsEnergy() {
  const char* const name = "euler-gains-energy";
  const auto fine = [](Scene& scene) { scene.solvers[1].step = 1.0 / 300; };
  const auto twin = [](Scene& scene) { scene.solvers[1].method = "semi-implicit-euler"; };
  const PlayedLesson rk4 = played(name, 0, 8);
  const core::Weight& weight = rk4.scene().weights[0];
  const double top =
      weight.mass * rk4.scene().gravity * (weight.rope->pivot.y() + weight.rope->length);
  const auto eulerAt = [&](double time) {
    return played(name, 1, time).run().energies().mechanical();
  };
  Extent twins;
  PlayedLesson semiImplicit(changed(name, twin), 1);
  semiImplicit.play(8, [&](const Run& run) { twins.include(run.energies().mechanical()); });
  return {
      {"energy", rk4.run().startEnergy(), 2, "J"},
      {"energy at the top", top, 2, "J"},
      {"moment", 1, 0, "s"},
      {"Euler's energy then", eulerAt(1), 2, "J"},
      {"moment", 3, 0, "s"},
      {"Euler's energy then", eulerAt(3), 2, "J"},
      {"moment", 5, 0, "s"},
      {"Euler's energy then", eulerAt(5), 2, "J"},
      {"over the top", timeOverTheTop(PlayedLesson(name, 1), 10), 1, "s"},
      {"drift with small steps", drift(played(changed(name, fine), 1, 5)), 2, "J"},
      {"over the top with small steps", timeOverTheTop(PlayedLesson(changed(name, fine), 1), 70), 0,
       "s"},
      {"lowest by semi-implicit Euler", twins.lowest, 2, "J"},
      {"highest by semi-implicit Euler", twins.highest, 2, "J"},
      // Rounded up: below it.
      {"Runge–Kutta's drift", std::ceil(1000 * driftPercent(rk4)) / 1000, 3, "%"},
      {"step", stepsPerSecond(rk4.scene(), 1), kFraction, "s"},
  };
}

Figures twoKindsOfEuler() {
  const char* const name = "two-kinds-of-euler";
  Extent energy;
  PlayedLesson semiImplicit(name);
  semiImplicit.play(60, [&](const Run& run) { energy.include(run.energies().mechanical()); });
  const PlayedLesson rk4 =
      played(changed(name, [](Scene& scene) { scene.solvers[1].method = "rk4"; }), 1, 60);
  return {
      {"energy", semiImplicit.run().startEnergy(), 2, "J"},
      {"lowest", energy.lowest, 2, "J"},
      {"highest", energy.highest, 2, "J"},
      {"over the top", timeOverTheTop(PlayedLesson(name, 1), 20), 1, "s"},
      {"moment", 10, 0, "s"},
      {"Euler's energy then", played(name, 1, 10).run().energies().mechanical(), 2, "J"},
      {"after a minute", played(name, 1, 60).run().energies().mechanical(), 0, "J"},
      {"Runge–Kutta's drift", driftPercent(rk4), 4, "%"},
      {"step", stepsPerSecond(semiImplicit.scene(), 0), kFraction, "s"},
  };
}

Figures halfTheStep() {
  const char* const name = "half-the-step";
  const auto error = [&](const Scene& scene, std::size_t solver, double time) {
    return apart(played(scene, 0, time), played(scene, solver, time));
  };
  const Scene asIs = ui::builtInScene(name);
  const Scene finer = changed(name, [](Scene& scene) { scene.solvers[3].step /= 2; });
  const double euler = error(asIs, 1, 1), halfEuler = error(asIs, 2, 1);
  const double rk4 = error(asIs, 3, 1), halfRk4 = error(finer, 3, 1);
  const double late = error(asIs, 1, 4), halfLate = error(asIs, 2, 4);
  constexpr double kTens = 10;
  return {
      {"moment", 1, 0, "s"},
      {"step", stepsPerSecond(asIs, 1), kFraction, "s"},
      {"Euler", euler, 3, "m"},
      {"step", stepsPerSecond(asIs, 2), kFraction, "s"},
      {"Euler, half the step", halfEuler, 3, "m"},
      {"factor", euler / halfEuler, 1, ""},
      {"Runge–Kutta", rk4, kPower, "m"},
      {"step", stepsPerSecond(asIs, 3), kFraction, "s"},
      {"Runge–Kutta, half the step", halfRk4, kPower, "m"},
      {"step", stepsPerSecond(finer, 3), kFraction, "s"},
      {"factor", rk4 / halfRk4, 0, ""},
      {"slopes a second", 4 * stepsPerSecond(asIs, 3), 0, ""},
      {"slopes a second, Euler", stepsPerSecond(asIs, 2), 0, ""},
      {"how much better", kTens * std::round(halfEuler / rk4 / kTens), 0, ""},
      {"moment", 4, 0, "s"},
      {"Euler", late, 3, "m"},
      {"Euler, half the step", halfLate, 3, "m"},
      {"factor", late / halfLate, 1, ""},
  };
}

Figures stepTooLarge() {
  const char* const name = "step-too-large";
  const auto speeds = [](PlayedLesson lesson, double until) {
    std::vector<double> all;
    lesson.play(until, [&](const Run& run) { all.push_back(run.weight(0).velocity.norm()); });
    return all;
  };
  const PlayedLesson start(name);
  const std::vector<double> rk4 = speeds(PlayedLesson(name), 0.1);
  const std::vector<double> dead = speeds(PlayedLesson(name, 1), 0.1);
  const std::vector<double> wild = speeds(PlayedLesson(name, 2), 1);
  const PlayedLesson diverged = played(name, 2, 2);
  constexpr double kThousandth = 1e-3;
  double limit = 0.055;
  const auto comesToRest = [&](double step) {
    const Scene scene = changed(name, [&](Scene& draft) { draft.solvers[2].step = step; });
    return played(scene, 2, 2).run().status() == core::RunStatus::kRunning;
  };
  while (comesToRest(limit)) limit += kThousandth;
  return {
      {"start", start.run().weight(0).velocity.norm(), 2, "m/s"},
      {"step", stepsPerSecond(start.scene(), 0), kFraction, "s"},
      {"after four steps", rk4.at(3), 2, "m/s"},
      {"step", stepsPerSecond(start.scene(), 1), kFraction, "s"},
      {"after one step", dead.at(0), 2, "m/s"},
      {"step", stepsPerSecond(start.scene(), 2), kFraction, "s"},
      {"back", wild.at(0), 1, "m/s"},
      {"forth", wild.at(1), 1, "m/s"},
      {"back again", wild.at(2), 0, "m/s"},
      {"forth again", wild.at(3), 0, "m/s"},
      {"last", wild.at(4), 0, "m/s"},
      {"end", diverged.run().time(), 3, "s"},
      {"a step that is not too large", comesToRest(1.0 / 16) ? 16.0 : 0.0, kFraction, "s"},
      {"limit", limit, 3, "s"},
  };
}

}  // namespace

const FiguresByLesson& methodFigures() {
  static const FiguresByLesson kLessons = {
      {"one-pendulum", onePendulum},
      {"seven-weights", sevenWeights},
      {"euler-gains-energy", eulerGainsEnergy},
      {"two-kinds-of-euler", twoKindsOfEuler},
      {"half-the-step", halfTheStep},
      {"step-too-large", stepTooLarge},
  };
  return kLessons;
}

}  // namespace tests
