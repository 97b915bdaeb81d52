#include "core/trade/bounded_step.h"

#include <cmath>

#include <QtTest>

#include "core/trade/boundedness.h"
#include "tests/support/reference_case.h"
#include "tests/support/thick_air.h"

using core::Boundedness;
using core::BoundedStep;

namespace {

std::optional<core::BoundednessTrial> trialOf(const std::shared_ptr<const core::Scene>& scene,
                                              const core::Solver& solver, double until) {
  core::WorkMeter meter(1, {});
  return core::boundednessOf(scene, solver, until, meter);
}

const BoundedStep& named(const std::vector<BoundedStep>& steps, std::string_view id) {
  for (const BoundedStep& step : steps) {
    if (step.method->id == id) return step;
  }
  qFatal("no such method");
}

}  // namespace

class BoundedStepTest : public QObject {
  Q_OBJECT

 private slots:
  void findsTheLimitOfEuler();
  void tellsApartWhatBecomesOfARun();
  void countsTheEnergyThatCanBeMovedWith();
  void aStepAboveTheLimitRunsAway();
  void whatFallsFreelyHasNoLimit();
  void endsWhenItIsTold();
};

void BoundedStepTest::findsTheLimitOfEuler() {
  const auto steps = core::largestBoundedSteps(tests::thickAir(), 100);
  const BoundedStep& euler = named(*steps, "euler");
  QVERIFY(!euler.isUnlimited);
  QCOMPARE(*euler.step, 0.033);  // 1/30 s down to two digits
}

void BoundedStepTest::tellsApartWhatBecomesOfARun() {
  const auto pendulum = tests::referenceCase("pendulum-vacuum-60").scene;
  QCOMPARE(trialOf(pendulum, {.method = "rk4", .step = 0.01}, 10)->outcome, Boundedness::kBounded);
  // Euler multiplies a small swing's energy by 1 + (g/L) h² a step: by e in 10 s at 0.01 s.
  const auto trial = trialOf(pendulum, {.method = "euler", .step = 0.02}, 10);
  QCOMPARE(trial->outcome, Boundedness::kRunaway);
  QVERIFY(1 < trial->drift && trial->drift < 1.1);
  QCOMPARE(trialOf(tests::thickAir(), {.method = "euler", .step = 10}, 100)->outcome,
           Boundedness::kRunaway);
}

void BoundedStepTest::countsTheEnergyThatCanBeMovedWith() {
  core::Scene scene = *tests::referenceCase("pendulum-vacuum-60").scene;
  QVERIFY(scene.weights[0].rope && !scene.cutTime);
  const double mass = scene.weights[0].mass, length = scene.weights[0].rope->length;
  const double swing = mass * scene.gravity * length / 2;  // 1 − cos 60°
  QVERIFY(std::abs(core::energyToMoveWith(scene) - swing) < 1e-12);
  scene.cutTime = 1;
  const double bottom = scene.weights[0].rope->pivot.y() - length - scene.weights[0].radius;
  QVERIFY(std::abs(core::energyToMoveWith(scene) - swing - mass * scene.gravity * bottom) < 1e-12);
}

void BoundedStepTest::aStepAboveTheLimitRunsAway() {
  const auto scene = tests::referenceCase("pendulum-vacuum-60").scene;
  const auto steps = core::largestBoundedSteps(scene, 10);
  const BoundedStep& euler = named(*steps, "euler");
  QVERIFY(euler.step && !euler.isUnlimited);
  QCOMPARE(trialOf(scene, {.method = "euler", .step = *euler.step}, 10)->outcome,
           Boundedness::kBounded);
  QCOMPARE(trialOf(scene, {.method = "euler", .step = 1.1 * *euler.step}, 10)->outcome,
           Boundedness::kRunaway);
  const BoundedStep& rungeKutta = named(*steps, "rk4");
  QVERIFY(*rungeKutta.step > 10 * *euler.step);
}

void BoundedStepTest::whatFallsFreelyHasNoLimit() {
  core::Scene scene;
  scene.airDensity = 0;
  scene.room.height = 1e4;
  scene.weights.resize(1);
  scene.weights[0].position = {2, 9e3};
  const auto steps = core::largestBoundedSteps(std::make_shared<const core::Scene>(scene), 4);
  const BoundedStep& rungeKutta = named(*steps, "rk4");
  QVERIFY(rungeKutta.isUnlimited);
  QCOMPARE(*rungeKutta.step, 4.0);
}

void BoundedStepTest::endsWhenItIsTold() {
  QVERIFY(!core::largestBoundedSteps(tests::thickAir(), 100, [](double) { return false; }));
}

QTEST_APPLESS_MAIN(BoundedStepTest)
#include "bounded_step_test.moc"
