#include "tests/ui/files/lesson_figures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <QLocale>

#include "core/run/run.h"
#include "tests/support/played_lesson.h"
#include "ui/chart/figure_text.h"
#include "ui/files/scene_file.h"

namespace tests {
namespace {

using core::Event;
using core::EventKind;
using core::Run;
using core::Scene;
using Figures = std::vector<LessonFigure>;

constexpr int kFraction = LessonFigure::kFraction;
constexpr int kPower = LessonFigure::kPower;
constexpr double kDegree = std::numbers::pi / 180;

/// The lesson's scene as its sheet asks for it to be changed.
template <class Edit>
Scene changed(const char* lesson, Edit edit) {
  Scene scene = ui::builtInScene(lesson);
  edit(scene);
  return scene;
}

/// A run of it, played that far.
PlayedLesson played(const Scene& scene, std::size_t solver, double until) {
  PlayedLesson lesson(scene, solver);
  lesson.play(until);
  return lesson;
}
PlayedLesson played(const char* name, std::size_t solver, double until) {
  return played(ui::builtInScene(name), solver, until);
}

/// Lowest and highest of something over a run's steps.
struct Extent {
  double lowest = INFINITY;
  double highest = -INFINITY;

  void include(double value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
};

double drift(const PlayedLesson& lesson) {
  return lesson.run().energies().numericalDrift;
}
double driftPercent(const PlayedLesson& lesson) {
  return 100 * std::abs(*lesson.run().energies().driftShare());
}

double stepsPerSecond(const Scene& scene, std::size_t solver) {
  return 1 / scene.solvers[solver].step;
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

Figures twoWeights() {
  const char* const name = "two-weights";
  PlayedLesson asIs(name);
  double heavyAfter = 0;
  asIs.play(2, [&](const Run& run) {
    for (const Event& event : run.stepEvents())
      if (event.kind == EventKind::kImpactWeight && heavyAfter == 0)
        heavyAfter = run.weightAt(1, event.time).velocity.norm();
  });
  const PlayedLesson equal =
      played(changed(name, [](Scene& scene) { scene.weights[0].mass = 1.52; }), 0, 2);
  const PlayedLesson dull =
      played(changed(name, [](Scene& scene) { scene.restitution = 0; }), 0, 2);
  const Event& impact = asIs.first(EventKind::kImpactWeight, 0);
  return {
      {"impact", impact.time, 3, "s"},
      {"light one before", impact.speedBefore, 2, "m/s"},
      {"light one after", impact.speedAfter, 2, "m/s"},
      {"heavy one after", heavyAfter, 2, "m/s"},
      {"equal masses before", equal.first(EventKind::kImpactWeight, 0).speedBefore, 2, "m/s"},
      {"equal masses after", equal.first(EventKind::kImpactWeight, 0).speedAfter, 2, "m/s"},
      {"lost without bounce", dull.first(EventKind::kImpactWeight, 0).energyLost, 2, "J"},
      {"energy", asIs.run().startEnergy(), 1, "J"},
      {"light one after that", dull.first(EventKind::kImpactWeight, 0).speedAfter, 2, "m/s"},
      {"step", stepsPerSecond(asIs.scene(), 0), kFraction, "s"},
  };
}

Figures threePendulums() {
  const char* const name = "three-pendulums";
  const auto firstTurn = [](const PlayedLesson& lesson, int weight) {
    return lesson.first(EventKind::kTurningPoint, weight).time;
  };
  const PlayedLesson asIs = played(name, 0, 2);
  const PlayedLesson shorter =
      played(changed(name, [](Scene& scene) { scene.weights[0].rope->length = 0.3; }), 0, 2);
  const PlayedLesson heavy =
      played(changed(name, [](Scene& scene) { scene.weights[0].mass *= 10; }), 0, 2);
  const auto length = [](const PlayedLesson& lesson, std::size_t weight) {
    return lesson.scene().weights[weight].rope->length;
  };
  return {
      {"first turn, weight 1", firstTurn(asIs, 0), 3, "s"},
      {"first turn, weight 2", firstTurn(asIs, 1), 3, "s"},
      {"first turn, weight 3", firstTurn(asIs, 2), 3, "s"},
      {"length 1", length(asIs, 0), 1, "m"},
      {"length 2", length(asIs, 1), 1, "m"},
      {"length 3", length(asIs, 2), 1, "m"},
      {"ratio", firstTurn(asIs, 2) / firstTurn(asIs, 0), 2, ""},
      {"short rope", length(shorter, 0), 1, "m"},
      {"first turn, short rope", firstTurn(shorter, 0), 3, "s"},
      {"first turn, heavy", firstTurn(heavy, 0), 3, "s"},
      {"step", stepsPerSecond(asIs.scene(), 0), kFraction, "s"},
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

Figures smallAndLargeSwings() {
  const char* const name = "small-and-large-swings";
  const PlayedLesson asIs = played(name, 0, 2);
  const Scene smallScene = changed(name, [](Scene& scene) {
    double angle = 0;
    for (core::Weight& weight : scene.weights) weight.rope->angle = (angle += 5 * kDegree);
  });
  const PlayedLesson smaller = played(smallScene, 0, 2);
  const PlayedLesson steep = played(
      changed(name, [](Scene& scene) { scene.weights[3].rope->angle = 179.9 * kDegree; }), 0, 5);
  const core::Rope& rope = *asIs.scene().weights[0].rope;
  const double formula = std::numbers::pi * std::sqrt(rope.length / asIs.scene().gravity);
  Figures figures = {{"formula", formula, 3, "s"}};
  const auto add = [&](const PlayedLesson& lesson, int weight) {
    const double angle = lesson.scene().weights[static_cast<std::size_t>(weight)].rope->angle;
    figures.push_back({"angle", angle / kDegree, 0, "°"});
    figures.push_back(
        {"its first turn", lesson.first(EventKind::kTurningPoint, weight).time, 3, "s"});
  };
  for (int weight = 0; weight < 4; ++weight) add(asIs, weight);
  for (const int weight : {0, 2, 3}) add(smaller, weight);
  const double twenty = smaller.first(EventKind::kTurningPoint, 3).time;
  figures.push_back({"right within", std::ceil(100 * (twenty / formula - 1)), 0, "%"});
  figures.push_back({"steepest", 179.9, 1, "°"});
  figures.push_back({"its first turn", steep.first(EventKind::kTurningPoint, 3).time, 3, "s"});
  figures.push_back({"step", stepsPerSecond(asIs.scene(), 0), kFraction, "s"});
  return figures;
}

Figures slackRope() {
  const char* const name = "slack-rope";
  Extent rod;
  PlayedLesson both(name);
  const double speed = both.run().weight(1).velocity.norm();
  const double tension = both.run().weight(1).tension;
  both.play(3, [&](const Run& run) {
    // Within the steps, too: the least is between two ends.
    for (int part = 0; part < 16; ++part) {
      const double time = run.time() - part * run.solver().step / 16;
      rod.include(run.weightAt(0, time).velocity.norm());
    }
  });
  const auto goesRound = [&](double gravity) {
    const Scene scene = changed(name, [&](Scene& draft) { draft.gravity = gravity; });
    return played(scene, 0, 3).count(EventKind::kSlack) == 0;
  };
  double gravity = 7.5;
  while (goesRound(gravity + 0.1)) gravity += 0.1;
  const Event& slack = both.first(EventKind::kSlack, 1);
  const Event& taut = both.first(EventKind::kTaut, 1);
  return {
      {"start", speed, 2, "m/s"},
      {"tension", tension, 2, "N"},
      {"slack", slack.time, 3, "s"},
      {"its height", slack.position.y(), 2, "m"},
      {"its speed", slack.speedBefore, 2, "m/s"},
      {"taut", taut.time, 3, "s"},
      {"lost", taut.energyLost, 2, "J"},
      {"speed before", taut.speedBefore, 2, "m/s"},
      {"speed after", taut.speedAfter, 2, "m/s"},
      {"rod at the top", rod.lowest, 2, "m/s"},
      {"gravity that stays taut", gravity, 1, "m/s²"},
      {"gravity that does not", gravity + 0.1, 1, "m/s²"},
      {"step", stepsPerSecond(both.scene(), 0), kFraction, "s"},
  };
}

Figures throwInAir() {
  const char* const name = "throw-in-air";
  Extent inAir, inVacuum;
  PlayedLesson both(name);
  both.play(1.6, [&](const Run& run) {
    for (int part = 0; part < 16; ++part) {
      const double time = run.time() - part * run.solver().step / 16;
      inAir.include(run.weightAt(0, time).position.y());
      inVacuum.include(run.weightAt(1, time).position.y());
    }
  });
  const PlayedLesson heavy =
      played(changed(name, [](Scene& scene) { scene.weights[0].mass = 0.3; }), 0, 1.6);
  const Event& air = both.first(EventKind::kImpactFloor, 0);
  const Event& vacuum = both.first(EventKind::kImpactFloor, 1);
  return {
      {"height in air", inAir.highest, 2, "m"},
      {"place in air", air.position.x(), 2, "m"},
      {"time in air", air.time, 3, "s"},
      {"height without", inVacuum.highest, 2, "m"},
      {"place without", vacuum.position.x(), 1, "m"},
      {"time without", vacuum.time, 3, "s"},
      {"speed in air", air.speedBefore, 2, "m/s"},
      {"speed without", vacuum.speedBefore, 1, "m/s"},
      {"lost to air", both.run().energies().lostToAir, 2, "J"},
      {"place of the heavy one", heavy.first(EventKind::kImpactFloor, 0).position.x(), 2, "m"},
      {"air density", 0, 0, ""},
      {"step", stepsPerSecond(both.scene(), 0), kFraction, "s"},
  };
}

/// √(g/q), see core/model.md, "Flight".
double terminalSpeed(const Scene& scene, std::size_t index) {
  const core::Weight& weight = scene.weights[index];
  const double area = std::numbers::pi * weight.radius * weight.radius;
  return std::sqrt(2 * weight.mass * scene.gravity /
                   (scene.airDensity * weight.dragCoefficient * area));
}

Figures terminalVelocity() {
  const char* const name = "terminal-velocity";
  const PlayedLesson balls = played(name, 0, 4);
  const PlayedLesson vacuum =
      played(changed(name, [](Scene& scene) { scene.airDensity = 0; }), 0, 2);
  const auto landing = [](const PlayedLesson& lesson, int weight) -> const Event& {
    return lesson.first(EventKind::kImpactFloor, weight);
  };
  return {
      {"mass 1", balls.scene().weights[0].mass, 2, "kg"},
      {"its speed", landing(balls, 0).speedBefore, 2, "m/s"},
      {"mass 2", balls.scene().weights[1].mass, 1, "kg"},
      {"its speed", landing(balls, 1).speedBefore, 2, "m/s"},
      {"mass 3", balls.scene().weights[2].mass, 0, "kg"},
      {"its terminal speed", terminalSpeed(balls.scene(), 2), 1, "m/s"},
      {"its speed", landing(balls, 2).speedBefore, 1, "m/s"},
      {"landing 1", landing(balls, 0).time, 3, "s"},
      {"landing 2", landing(balls, 1).time, 3, "s"},
      {"landing 3", landing(balls, 2).time, 3, "s"},
      {"landing without air", landing(vacuum, 0).time, 3, "s"},
      {"speed without air", landing(vacuum, 2).speedBefore, 1, "m/s"},
      {"step", stepsPerSecond(balls.scene(), 0), kFraction, "s"},
  };
}

Figures bouncingBall() {
  const char* const name = "bouncing-ball";
  const PlayedLesson ball = played(name, 0, 6);
  std::vector<double> impacts;
  for (const Event& event : ball.events())
    if (event.kind == EventKind::kImpactFloor) impacts.push_back(event.time);
  const core::Weight& weight = ball.scene().weights[0];
  const double e = ball.scene().room.restitution;
  const double fall = std::sqrt(2 * (weight.position.y() - weight.radius) / ball.scene().gravity);
  const PlayedLesson lively =
      played(changed(name, [](Scene& scene) { scene.room.restitution = 0.9; }), 0, 12);
  return {
      {"impact 1", impacts.at(0), 3, "s"},
      {"impact 2", impacts.at(1), 3, "s"},
      {"impact 3", impacts.at(2), 3, "s"},
      {"impact 4", impacts.at(3), 3, "s"},
      {"between 1 and 2", impacts.at(1) - impacts.at(0), 3, "s"},
      {"between 2 and 3", impacts.at(2) - impacts.at(1), 3, "s"},
      {"between 3 and 4", impacts.at(3) - impacts.at(2), 3, "s"},
      {"ratio", (impacts[3] - impacts[2]) / (impacts[2] - impacts[1]), 1, ""},
      {"end of the series", fall * (1 + e) / (1 - e), 3, "s"},
      {"impacts", static_cast<double>(impacts.size()), 0, ""},
      {"rest", ball.first(EventKind::kRest, 0).time, 3, "s"},
      {"other restitution", 0.9, 1, ""},
      {"rest then", lively.first(EventKind::kRest, 0).time, 2, "s"},
      {"step", stepsPerSecond(ball.scene(), 0), kFraction, "s"},
  };
}

Figures newtonsCradle() {
  const char* const name = "newtons-cradle";
  const PlayedLesson cradle = played(name, 0, 2);
  const auto lift = [](Scene& scene) { scene.weights[1].rope->angle = -40 * kDegree; };
  const PlayedLesson pair = played(changed(name, lift), 0, 1.2);
  PlayedLesson dull = played(changed(name, [](Scene& scene) { scene.restitution = 0.5; }), 0, 20);
  const core::Weight& first = cradle.scene().weights[0];
  const double swing =
      first.mass * cradle.scene().gravity * first.rope->length * (1 - std::cos(first.rope->angle));
  const double lost = dull.run().energies().lostToImpacts;
  Extent angles;
  dull.play(25, [&](const Run& run) {
    for (int i = 0; i < run.weightCount(); ++i) angles.include(std::abs(run.weight(i).angle));
  });
  const Event& impact = cradle.first(EventKind::kImpactWeight, 0);
  return {
      {"speed", impact.speedBefore, 2, "m/s"},
      {"impact", impact.time, 3, "s"},
      {"last one's turn", cradle.first(EventKind::kTurningPoint, 4).time, 3, "s"},
      {"its angle", std::abs(first.rope->angle) / kDegree, 0, "°"},
      {"moment", pair.run().time(), 1, "s"},
      {"weight 4 then", pair.run().weight(3).angle / kDegree, 0, "°"},
      {"weight 5 then", pair.run().weight(4).angle / kDegree, 0, "°"},
      {"other restitution", 0.5, 1, ""},
      {"lost", lost, 3, "J"},
      {"swing", swing, 3, "J"},
      // Rounded up: less than it.
      {"in the end", std::ceil(angles.highest / kDegree), 0, "°"},
      {"step", stepsPerSecond(cradle.scene(), 0), kFraction, "s"},
  };
}

/// What happens until the heavy disc is at the right wall.
struct Clacks {
  int count = 0;
  double first = 0;    ///< [s]
  double last = 0;     ///< [s]
  double fastest = 0;  ///< of the light disc [m/s]
};

Clacks clacks(const Scene& scene) {
  PlayedLesson discs(scene);
  while (std::ranges::find(discs.events(), EventKind::kImpactEast, &Event::kind) ==
         discs.events().end())
    discs.play(discs.run().time() + 1);
  Clacks clacks;
  for (const Event& event : discs.events()) {
    if (event.kind == EventKind::kImpactEast) break;
    if (clacks.count++ == 0) clacks.first = event.time;
    clacks.last = event.time;
    if (event.weight == 0) clacks.fastest = std::max(clacks.fastest, event.speedAfter);
  }
  return clacks;
}

Figures countingPi() {
  const char* const name = "counting-pi";
  const Scene scene = ui::builtInScene(name);
  const Clacks asIs = clacks(scene);
  const Clacks heavy = clacks(changed(name, [](Scene& draft) { draft.weights[1].mass = 1000; }));
  const Scene coarse = changed(name, [](Scene& draft) { draft.solvers[0].step *= 10; });
  return {
      {"ratio", scene.weights[1].mass / scene.weights[0].mass, 0, ""},
      {"impacts", static_cast<double>(asIs.count), 0, ""},
      {"first", asIs.first, 3, "s"},
      {"last", asIs.last, 3, "s"},
      {"other mass", 1000, 0, "kg"},
      {"impacts then", static_cast<double>(heavy.count), 0, ""},
      {"fastest", asIs.fastest, 2, "m/s"},
      {"fastest then", heavy.fastest, 1, "m/s"},
      {"large step", stepsPerSecond(coarse, 0), kFraction, "s"},
      {"step", stepsPerSecond(scene, 0), kFraction, "s"},
      {"impacts with it", static_cast<double>(clacks(coarse).count), 0, ""},
  };
}

/// The largest angle between two weights that started side by side, now [°].
double widestGap(const Run& run) {
  double widest = 0;
  for (int i = 1; i < run.weightCount(); ++i)
    widest = std::max(widest, std::abs(run.weight(i).angle - run.weight(i - 1).angle));
  return widest / kDegree;
}

Figures thousandPendulums() {
  const char* const name = "thousand-pendulums";
  const auto turn = [](const PlayedLesson& lesson, int weight) {
    return lesson.first(EventKind::kTurningPoint, weight).time;
  };
  const auto gapAt = [](PlayedLesson& lesson, double time) {
    lesson.play(time);
    return widestGap(lesson.run());
  };
  PlayedLesson line(name);
  PlayedLesson steep(changed(name, [](Scene& scene) {
    for (core::Weight& weight : scene.weights) weight.rope->angle = 170 * kDegree;
  }));
  const double gap5 = gapAt(line, 5), gap10 = gapAt(line, 10), gap20 = gapAt(line, 20);
  const double steep5 = gapAt(steep, 5), steep20 = gapAt(steep, 20);
  return {
      {"shortest", line.scene().weights.front().rope->length, 1, "m"},
      {"its first turn", turn(line, 0), 3, "s"},
      {"longest", line.scene().weights.back().rope->length, 3, "m"},
      {"its first turn", turn(line, 999), 3, "s"},
      {"ratio", turn(line, 999) / turn(line, 0), 2, ""},
      {"moment", 5, 0, "s"},
      {"widest gap then", gap5, 1, "°"},
      {"moment", 10, 0, "s"},
      {"widest gap then", gap10, 1, "°"},
      {"moment", 20, 0, "s"},
      {"widest gap then", gap20, 1, "°"},
      {"steep start", 170, 0, "°"},
      {"shortest, steep", turn(steep, 0), 3, "s"},
      {"longest, steep", turn(steep, 999), 3, "s"},
      {"widest gap, steep", steep5, 1, "°"},
      {"later", steep20, 1, "°"},
      {"step", stepsPerSecond(line.scene(), 0), kFraction, "s"},
  };
}

/// When the last weight stops for good: nothing moves that an eye could see afterwards [s].
double timeUntilStill(PlayedLesson& pile, double until) {
  constexpr double kSeen = 1e-3;  // J
  double still = 0;
  pile.play(until, [&](const Run& run) {
    if (run.energies().kinetic > kSeen) still = run.time();
  });
  return still;
}

double highest(const Run& run) {
  double top = 0;
  for (int i = 0; i < run.weightCount(); ++i)
    top = std::max(
        top, run.weight(i).position.y() + run.scene().weights[static_cast<std::size_t>(i)].radius);
  return top;
}

Figures pile() {
  const char* const name = "pile";
  PlayedLesson balls(name);
  PlayedLesson lively(
      changed(name, [](Scene& scene) { scene.restitution = scene.room.restitution = 0.8; }));
  const PlayedLesson wide =
      played(changed(name, [](Scene& scene) { scene.room.width *= 2; }), 0, 4);
  const double still = timeUntilStill(balls, 4);
  const core::Energies energies = balls.run().energies();
  return {
      {"still", still, 1, "s"},
      {"energy", balls.run().startEnergy(), 1, "J"},
      {"potential", energies.potential, 1, "J"},
      {"impacts", energies.lostToImpacts, 1, "J"},
      {"friction", energies.lostToFriction, 1, "J"},
      {"air", energies.lostToAir, 1, "J"},
      {"drift", std::abs(energies.numericalDrift), 2, "J"},
      {"the same in percent", driftPercent(balls), 2, "%"},
      {"height", highest(balls.run()), 2, "m"},
      {"other restitution", 0.8, 1, ""},
      {"still then", timeUntilStill(lively, 4), 0, "s"},
      {"other width", wide.scene().room.width, 2, "m"},
      {"height then", highest(wide.run()), 2, "m"},
      {"step", stepsPerSecond(balls.scene(), 0), kFraction, "s"},
  };
}

}  // namespace

QString LessonFigure::text() const {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  if (decimals == kFraction) return QStringLiteral("1/") + locale.toString(value, 'f', 0);
  if (decimals == kPower) return ui::figure(value);
  return locale.toString(value, 'f', decimals);
}

std::vector<LessonFigure> lessonFigures(const QString& lesson) {
  static const std::map<QString, Figures (*)()> kLessons = {
      {"one-pendulum", onePendulum},
      {"two-weights", twoWeights},
      {"three-pendulums", threePendulums},
      {"seven-weights", sevenWeights},
      {"euler-gains-energy", eulerGainsEnergy},
      {"two-kinds-of-euler", twoKindsOfEuler},
      {"half-the-step", halfTheStep},
      {"step-too-large", stepTooLarge},
      {"small-and-large-swings", smallAndLargeSwings},
      {"slack-rope", slackRope},
      {"throw-in-air", throwInAir},
      {"terminal-velocity", terminalVelocity},
      {"bouncing-ball", bouncingBall},
      {"newtons-cradle", newtonsCradle},
      {"counting-pi", countingPi},
      {"thousand-pendulums", thousandPendulums},
      {"pile", pile},
  };
  return kLessons.at(lesson)();
}

}  // namespace tests
