#include "core/trade/step_ends.h"

#include <cmath>
#include <memory>

#include <QtTest>

using core::ExactWay;
using core::Run;
using core::Scene;
using core::StepEnd;
using core::StepPart;

namespace {

constexpr double kGravity = 10;  // m/s²

/// A weight thrown without air: x = 1 + 3 t, y = 1 + 4 t − 5 t².
Scene thrown() {
  Scene scene;
  scene.gravity = kGravity;
  scene.airDensity = 0;
  core::Weight weight;
  weight.position = {1, 1};
  weight.velocity = {3, 4};
  scene.weights = {weight};
  return scene;
}

/// A swing of 1 m let go at 120° without air, as in tests/reference/pendulum-vacuum-120.
Scene swinging() {
  Scene scene;
  scene.airDensity = 0;
  core::Weight weight;
  weight.rope =
      core::Rope{.pivot = {2, 1.5}, .length = 1, .angle = 2 * std::acos(-1) / 3, .rigid = true};
  scene.weights = {weight};
  return scene;
}

Run after(const Scene& scene, double step) {
  Run run(std::make_shared<const Scene>(scene), {.method = "rk4", .step = step});
  run.advance();
  return run;
}

}  // namespace

/// What methods make of a part of a step, beside the exact end.
class StepEndsTest : public QObject {
  Q_OBJECT

 private slots:
  void theExactWayIsTheParabolaOfAThrow();
  void theExactWayKeepsTheEnergyOfASwing();
  void errorsAreWhatTheyAreByHand();
  void errorsOfOneStepFallWithOnePowerMoreThanTheOrder();
};

void StepEndsTest::theExactWayIsTheParabolaOfAThrow() {
  const Run run = after(thrown(), 0.1);
  const ExactWay way = core::exactWay(run, 0, run.latestStep(0)[0]);
  QCOMPARE(way.times.size(), way.states.size());
  QCOMPARE(way.times.front(), 0.0);
  QCOMPARE(way.times.back(), 0.1);
  for (std::size_t i = 0; i < way.times.size(); ++i) {
    const double t = way.times[i];
    QVERIFY(std::abs(way.states[i][0] - (1 + 3 * t)) < 1e-13);
    QVERIFY(std::abs(way.states[i][1] - (1 + 4 * t - 5 * t * t)) < 1e-13);
  }
  QCOMPARE(way.position, Eigen::Vector2d(way.end()[0], way.end()[1]));
}

void StepEndsTest::theExactWayKeepsTheEnergyOfASwing() {
  const Run run = after(swinging(), 0.5);
  const ExactWay way = core::exactWay(run, 0, run.latestStep(0)[0]);
  const auto energy = [](const core::Entries& state) {
    return 0.5 * state[2] * state[2] - 9.81 * std::cos(state[0]);
  };
  QVERIFY(std::abs(way.end()[0] - way.states.front()[0]) > 0.5);
  // A thousand roundings of numbers about ten.
  QVERIFY(std::abs(energy(way.end()) - energy(way.states.front())) < 1e-12);
}

void StepEndsTest::errorsAreWhatTheyAreByHand() {
  const Run run = after(thrown(), 0.1);
  const StepPart part = run.latestStep(0)[0];
  const ExactWay way = core::exactWay(run, 0, part);
  const std::vector<StepEnd> ends =
      core::stepEnds(run, 0, part, way, {core::findMethod("euler"), core::findMethod("rk4")});
  QCOMPARE(ends.size(), std::size_t{2});
  // Euler falls not at all in its first step, where the weight falls g h²/2.
  QCOMPARE(ends[0].method, core::findMethod("euler"));
  QVERIFY(std::abs(ends[0].error - kGravity * 0.1 * 0.1 / 2) < 1e-12);
  QVERIFY(std::abs(ends[0].position.y() - 1.4) < 1e-13);
  // Runge–Kutta 4 is exact for a parabola.
  QVERIFY(ends[1].error < 1e-13);
}

void StepEndsTest::errorsOfOneStepFallWithOnePowerMoreThanTheOrder() {
  const auto errorOf = [](const char* method, double step) {
    const Run run = after(swinging(), step);
    const StepPart part = run.latestStep(0)[0];
    return core::stepEnds(run, 0, part, core::exactWay(run, 0, part), {core::findMethod(method)})[0]
        .error;
  };
  // The next power of the step adds under 0.05. That of Euler's place is exactly 2, as
  // ω θ' = −(g/L) sin θ enters with h²/2.
  QVERIFY(std::abs(std::log2(errorOf("euler", 0.02) / errorOf("euler", 0.01)) - 2) < 0.05);
  // From rest the terms of h⁵ vanish in θ: h⁶ comes first.
  QVERIFY(std::abs(std::log2(errorOf("rk4", 0.1) / errorOf("rk4", 0.05)) - 6) < 0.1);
}

QTEST_APPLESS_MAIN(StepEndsTest)
#include "step_ends_test.moc"
