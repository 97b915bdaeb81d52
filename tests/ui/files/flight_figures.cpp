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

Figures throwInAir() {
  const char* const name = "throw-in-air";
  Extent inAir, inVacuum;
  PlayedLesson both(name);
  both.play(1.6, [&](const Run& run) {
    lookInside(run, [&](double time) {
      inAir.include(run.weightAt(0, time).position.y());
      inVacuum.include(run.weightAt(1, time).position.y());
    });
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

const FiguresByLesson& flightFigures() {
  static const FiguresByLesson kLessons = {
      {"two-weights", twoWeights},
      {"throw-in-air", throwInAir},
      {"terminal-velocity", terminalVelocity},
      {"bouncing-ball", bouncingBall},
      {"newtons-cradle", newtonsCradle},
      {"counting-pi", countingPi},
      {"pile", pile},
  };
  return kLessons;
}

}  // namespace tests
