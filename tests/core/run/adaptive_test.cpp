#include <cmath>
#include <memory>

#include <QtTest>

#include "core/methods/method.h"
#include "core/run/run_state.h"
#include "tests/support/fingerprint.h"
#include "tests/support/reference_case.h"

using core::Run;
using core::RunStatus;
using core::Scene;
using core::Solver;
using tests::Course;
using tests::ReferenceCase;

namespace {

Solver dopri5(double tolerance, double step) {
  return {.method = "dopri5", .step = step, .tolerance = tolerance};
}

/// One weight that flies through air and meets nothing for a second.
std::shared_ptr<const Scene> thrown() {
  Scene scene;
  scene.room = {.width = 100, .height = 100, .restitution = 1, .friction = 0};
  scene.weights.resize(1);
  scene.weights[0].mass = 0.0027;
  scene.weights[0].position = {10, 50};
  scene.weights[0].velocity = {12, 7};
  return std::make_shared<const Scene>(std::move(scene));
}

/// The lightest and largest weight at the highest speed in the thickest medium.
std::shared_ptr<const Scene> stiffest() {
  Scene scene;
  scene.airDensity = 2000;
  scene.room = {.width = 1e5, .height = 1e5, .restitution = 1, .friction = 0};
  scene.weights.resize(1);
  scene.weights[0].mass = 1e-6;
  scene.weights[0].radius = 100;
  scene.weights[0].dragCoefficient = 10;
  scene.weights[0].position = {5e4, 5e4};
  scene.weights[0].velocity = {1e5, 0};
  return std::make_shared<const Scene>(std::move(scene));
}

}  // namespace

/// Whole runs of a method that chooses its own steps.
class AdaptiveTest : public QObject {
  Q_OBJECT

 private slots:
  void reachesTheExactAnswers_data();
  void reachesTheExactAnswers();
  void listsTheSameEventsInTheSameOrder_data();
  void listsTheSameEventsInTheSameOrder();
  void hasAnErrorInProportionToItsTolerance_data();
  void hasAnErrorInProportionToItsTolerance();
  void takesLongerStepsWhereItMay();
  void asksForEachSlopeOnce();
  void goesOnFromAStateAtTheSamePace();
  void letsWeightsKeepTheirOwnPace();
  void seesWhatPassesWithinOneOfItsSteps();
  void comesToAnEndAtEveryTolerance_data();
  void comesToAnEndAtEveryTolerance();
  void stopsWhereNoStepKeepsTheTolerance();

 private:
  void addReferences();
};

void AdaptiveTest::addReferences() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<double>("step");
  for (const QString& name : tests::referenceNames())
    for (const double step : {1.0 / 60, 1.0})
      QTest::addRow("%s, looked at every %g s", qPrintable(name), step) << name << step;
}

void AdaptiveTest::reachesTheExactAnswers_data() {
  addReferences();
}

void AdaptiveTest::reachesTheExactAnswers() {
  QFETCH(QString, name);
  QFETCH(double, step);
  const ReferenceCase reference = tests::referenceCase(name);
  const double error = positionError(reference, simulated(reference, dopri5(1e-12, step)));
  // Hundreds of steps add up to a hundred times the tolerance; on pendulums errors grow with time.
  QVERIFY2(error <= 1e-9, qPrintable(QString::number(error)));
}

void AdaptiveTest::listsTheSameEventsInTheSameOrder_data() {
  addReferences();
}

void AdaptiveTest::listsTheSameEventsInTheSameOrder() {
  QFETCH(QString, name);
  QFETCH(double, step);
  const ReferenceCase reference = tests::referenceCase(name);
  for (const double tolerance : {1e-6, 1e-9}) {
    const Course course = simulated(reference, dopri5(tolerance, step));
    QCOMPARE(course.events.size(), reference.exact.events.size());
    for (std::size_t i = 0; i < course.events.size(); ++i) {
      QCOMPARE(course.events[i].kind, reference.exact.events[i].kind);
      QCOMPARE(course.events[i].weight, reference.exact.events[i].weight);
      QCOMPARE(course.events[i].other, reference.exact.events[i].other);
      QVERIFY(std::abs(course.events[i].time - reference.exact.events[i].time) < 100 * tolerance);
    }
  }
}

void AdaptiveTest::hasAnErrorInProportionToItsTolerance_data() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"cut-and-bounce", "pendulum-air", "pendulum-vacuum-120",
                           "pendulum-vacuum-60", "projectile-air", "two-ropes-collide"})
    QTest::newRow(name) << name;
}

void AdaptiveTest::hasAnErrorInProportionToItsTolerance() {
  QFETCH(QString, name);
  const ReferenceCase reference = tests::referenceCase(name);
  // Long steps of the run, so that the tolerance alone decides.
  const auto error = [&](double tolerance) {
    return positionError(reference, simulated(reference, dopri5(tolerance, 1)));
  };
  const double slope = std::log10(error(1e-6) / error(1e-11)) / 5;
  // A step's error goes with its 6th power and the sum of them with the 5th, which alone would
  // give 5/6; the error is estimated with the worse solution of order 4, which gives 1.
  QVERIFY2(std::abs(slope - 1) <= 0.1, qPrintable(QString::number(slope)));
}

void AdaptiveTest::takesLongerStepsWhereItMay() {
  const auto evaluations = [](double tolerance) {
    Run run(tests::referenceCase("pendulum-vacuum-60").scene, dopri5(tolerance, 1));
    while (run.time() < 10) run.advance();
    return static_cast<double>(run.slopeEvaluations());
  };
  // A tolerance 10⁵ times larger takes steps 10 times longer.
  const double ratio = evaluations(1e-11) / evaluations(1e-6);
  QVERIFY2(std::abs(ratio - 10) <= 3.5, qPrintable(QString::number(ratio)));
}

void AdaptiveTest::asksForEachSlopeOnce() {
  Run run(thrown(), dopri5(1e-6, 0.1));
  run.advance();
  // Two to find a first step; then six a step, the last one the first of the next.
  const std::int64_t first = run.slopeEvaluations();
  QCOMPARE((first - 2) % 6, 0);
  run.advance();
  QCOMPARE((run.slopeEvaluations() - first) % 6, 0);
  QVERIFY(run.slopeEvaluations() - first >= 6);
}

void AdaptiveTest::goesOnFromAStateAtTheSamePace() {
  Run run(thrown(), dopri5(1e-9, 0.1)), resumed(thrown(), dopri5(1e-9, 0.1));
  for (int i = 0; i < 3; ++i) run.advance();
  resumed.restore(run.state());
  const std::int64_t before = run.slopeEvaluations();
  run.advance();
  resumed.advance();
  QCOMPARE(resumed.slopeEvaluations(), run.slopeEvaluations());
  QCOMPARE((run.slopeEvaluations() - before) % 6, 0);
  QVERIFY(tests::fingerprint(resumed) == tests::fingerprint(run));
}

void AdaptiveTest::letsWeightsKeepTheirOwnPace() {
  const auto evaluations = [](int slow, int fast) {
    Scene scene;
    scene.room.width = 10;
    for (int i = 0; i < slow + fast; ++i) {
      core::Weight weight;
      const bool isSlow = i < slow;
      weight.rope = core::Rope{
          .pivot = {1.0 + 2 * i, 2.5}, .length = isSlow ? 1 : 0.1, .angle = isSlow ? 0.01 : 1.5};
      scene.weights.push_back(weight);
    }
    Run run(std::make_shared<const Scene>(scene), dopri5(1e-9, 1));
    run.advance();
    return run.slopeEvaluations();
  };
  QVERIFY(evaluations(0, 1) > 3 * evaluations(1, 0));
  QCOMPARE(evaluations(3, 1), 3 * evaluations(1, 0) + evaluations(0, 1));
}

void AdaptiveTest::seesWhatPassesWithinOneOfItsSteps() {
  // A small weight grazes another at 1000 m/s: they touch for microseconds, while a step of a
  // way without a bend takes two seconds.
  Scene scene;
  scene.gravity = 0;
  scene.airDensity = 0;
  scene.room = {.width = 5000, .height = 10, .restitution = 1, .friction = 0};
  core::Weight bullet, target;
  bullet.radius = target.radius = 0.01;
  bullet.position = {1, 5};
  bullet.velocity = {1000, 0};
  target.position = {700, 5.0199};  // grazed by a tenth of a millimeter
  scene.weights = {bullet, target};
  Run run(std::make_shared<const Scene>(scene), dopri5(1, 2));
  run.advance();
  QVERIFY(!run.stepEvents().empty());
  QCOMPARE(run.stepEvents()[0].kind, core::EventKind::kImpactWeight);
  // Both centers are √(0.02² − 0.0199²) m apart along the way then.
  QVERIFY(std::abs(run.stepEvents()[0].time -
                   (699 - std::sqrt(0.02 * 0.02 - 0.0199 * 0.0199)) / 1000) < 1e-12);
}

void AdaptiveTest::comesToAnEndAtEveryTolerance_data() {
  QTest::addColumn<double>("tolerance");
  QTest::addColumn<double>("step");
  for (const double tolerance : {1e-14, 1e-7, 1.0})
    for (const double step : {1e-7, 1.0 / 60, 10.0})
      QTest::addRow("%g, steps of %g s", tolerance, step) << tolerance << step;
}

void AdaptiveTest::comesToAnEndAtEveryTolerance() {
  QFETCH(double, tolerance);
  QFETCH(double, step);
  for (const QString& name : {QStringLiteral("rope-goes-slack"), QStringLiteral("pendulum-air")}) {
    Run run(tests::referenceCase(name).scene, dopri5(tolerance, step));
    for (int i = 0; i < 20; ++i) QCOMPARE(run.advance(), RunStatus::kRunning);
    QVERIFY(run.weight(0).position.allFinite());
  }
}

void AdaptiveTest::stopsWhereNoStepKeepsTheTolerance() {
  // Drag turns the speed around within 10⁻²⁰ s.
  for (const double tolerance : {1e-14, 1.0}) {
    Run run(stiffest(), dopri5(tolerance, 1.0 / 60));
    const std::vector<double> before = tests::fingerprint(run);
    for (int i = 0; i < 10 && run.status() == RunStatus::kRunning; ++i) run.advance();
    QCOMPARE(run.status(), RunStatus::kStalled);
    QVERIFY(tests::fingerprint(run) == before);
  }
}

QTEST_APPLESS_MAIN(AdaptiveTest)
#include "adaptive_test.moc"
