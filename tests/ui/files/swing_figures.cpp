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
    lookInside(run, [&](double time) { rod.include(run.weightAt(0, time).velocity.norm()); });
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

}  // namespace

const FiguresByLesson& swingFigures() {
  static const FiguresByLesson kLessons = {
      {"three-pendulums", threePendulums},
      {"small-and-large-swings", smallAndLargeSwings},
      {"slack-rope", slackRope},
      {"thousand-pendulums", thousandPendulums},
  };
  return kLessons;
}

}  // namespace tests
