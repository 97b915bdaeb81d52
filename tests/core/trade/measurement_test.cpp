#include "core/trade/measurement.h"

#include <cmath>

#include <QtTest>

#include "core/scene/arrangement.h"
#include "core/trade/work_precision.h"
#include "tests/support/reference_case.h"

using core::Measurement;
using core::MethodCurve;
using core::Solver;

namespace {

/// Measured once for all tests.
const Measurement& ofThePendulum() {
  static const Measurement measurement = *core::measure(
      tests::referenceCase("pendulum-vacuum-120").scene, core::measuredSolvers(), 10);
  return measurement;
}

/// Twelve discs that hit each other and the walls for ten seconds, nothing lost: a billiard.
std::shared_ptr<const core::Scene> chaos() {
  core::Scene scene;
  scene.gravity = 0;
  scene.airDensity = 0;
  scene.room = {.width = 2, .height = 2, .restitution = 1, .friction = 0};
  for (int i = 0; i < 12; ++i) {
    core::Weight disc;
    disc.radius = 0.1;
    const int column = i % 4, row = i / 4;
    disc.position = {0.4 + 0.4 * column, 0.5 + 0.45 * row};
    disc.velocity = {std::cos(i * i), std::sin(3 * i)};
    scene.weights.push_back(disc);
  }
  return std::make_shared<const core::Scene>(std::move(scene));
}

}  // namespace

class MeasurementTest : public QObject {
  Q_OBJECT

 private slots:
  void observesTheOrderOfEachMethod_data();
  void observesTheOrderOfEachMethod();
  void agreesWithAnExactAnswer_data();
  void agreesWithAnExactAnswer();
  void countsStepsAndEvaluations();
  void measuresTheDrift();
  void costGrowsWithTheNumberOfSteps();
  void measuresNoLongerThanAnAnswerIsKnown();
  void saysWhatDivergedAndWhen();
  void endsWhenItIsTold();
  void progressRisesFromNothingToAll();
  void aSceneWithoutWeightsHasNoErrors();
};

void MeasurementTest::observesTheOrderOfEachMethod_data() {
  QTest::addColumn<QString>("method");
  for (const core::Method& method : core::methods()) {
    if (!method.isAdaptive) {
      QTest::newRow(method.id.data()) << QString::fromUtf8(method.id.data());
    }
  }
}

void MeasurementTest::observesTheOrderOfEachMethod() {
  QFETCH(QString, method);
  const core::Method* row = core::findMethod(method.toStdString());
  const auto curve = std::ranges::find(ofThePendulum().curves, row, &MethodCurve::method);
  const auto law = core::errorLawOf(ofThePendulum(), *curve);
  QVERIFY(law);
  // What is left of higher powers of the step, and rounding, move it by a few hundredths.
  QVERIFY2(std::abs(law->order - row->order) <= 0.1, qPrintable(QString::number(law->order)));
  QVERIFY(core::reach(ofThePendulum(), *curve, 1e-6));
}

void MeasurementTest::agreesWithAnExactAnswer_data() {
  QTest::addColumn<QString>("method");
  QTest::newRow("euler") << "euler";
  QTest::newRow("rk4") << "rk4";
}

void MeasurementTest::agreesWithAnExactAnswer() {
  QFETCH(QString, method);
  // Up to 0.5 s the error of the swing only grows, so that the largest is that at the end.
  tests::ReferenceCase exact = tests::referenceCase("pendulum-vacuum-120");
  exact.exact.moments.resize(1);
  QCOMPARE(exact.exact.moments[0].time, 0.5);
  const Solver solver{.method = method.toStdString(), .step = 1.0 / 64};
  const double error = positionError(exact, simulated(exact, solver));
  const auto measured = core::measure(exact.scene, {solver}, 0.5);
  QVERIFY(error > 1e-9);
  // As far as the reference solution is known.
  QVERIFY2(std::abs(measured->curves[0].points[0].maxPositionError - error) < 1e-12,
           qPrintable(QString::number(error, 'g', 12)));
}

void MeasurementTest::countsStepsAndEvaluations() {
  const core::MeasuredPoint& euler = ofThePendulum().curves.front().points.front();
  QCOMPARE(euler.solver.step, 0.125);
  QCOMPARE(euler.steps, std::int64_t{80});
  QCOMPARE(euler.evaluations, std::int64_t{80});
  QCOMPARE(euler.reached, 10.0);
}

void MeasurementTest::measuresTheDrift() {
  const Solver solver{.method = "euler", .step = 1.0 / 64};
  const auto scene = tests::referenceCase("pendulum-vacuum-60").scene;
  core::Run run(scene, solver);
  double largest = 0;
  while (run.time() < 5 && run.advance() == core::RunStatus::kRunning) {
    largest = std::max(largest, std::abs(run.energies().numericalDrift));
  }
  QVERIFY(largest > 0.01);
  QCOMPARE(core::measure(scene, {solver}, 5)->curves[0].points[0].maxEnergyDrift, largest);
}

void MeasurementTest::costGrowsWithTheNumberOfSteps() {
  for (const MethodCurve& curve : ofThePendulum().curves) {
    if (curve.method->isAdaptive) continue;
    const auto& points = curve.points;
    const double ratio = points.back().nanosecondsPerSimulatedSecond /
                         points[points.size() - 4].nanosecondsPerSimulatedSecond;
    // Eight times the steps; a busy machine may spoil a median a little.
    QVERIFY2(5 < ratio && ratio < 12, qPrintable(QString::number(ratio)));
  }
}

void MeasurementTest::measuresNoLongerThanAnAnswerIsKnown() {
  const auto measured = core::measure(chaos(), {{.method = "rk4", .step = 1.0 / 64}}, 60);
  QVERIFY(measured->endsEarly());
  QVERIFY2(1 < measured->until && measured->until < 50,
           qPrintable(QString::number(measured->until)));
  QVERIFY(measured->uncertainty <= 1e-6);
  QVERIFY(measured->curves[0].points[0].reached < measured->until + 1.0 / 64);
  QVERIFY(!ofThePendulum().endsEarly());
  QCOMPARE(ofThePendulum().until, 10.0);
}

void MeasurementTest::saysWhatDivergedAndWhen() {
  core::Scene scene;
  scene.airDensity = 30;
  scene.room.width = 1000;
  core::Weight ball;
  ball.mass = 1e-3;
  ball.position = {1, 1};
  ball.velocity = {100, 0};
  scene.weights = {ball};
  const auto shared = std::make_shared<const core::Scene>(scene);
  const Solver solver{.method = "euler", .step = 0.05};
  core::Run run(shared, solver);
  while (run.advance() == core::RunStatus::kRunning) {
  }
  QVERIFY(run.time() < 5);
  const auto measured = core::measure(shared, {solver}, 5);
  QCOMPARE(measured->curves[0].points[0].status, core::RunStatus::kDiverged);
  QCOMPARE(measured->curves[0].points[0].reached, run.time());
}

void MeasurementTest::endsWhenItIsTold() {
  const auto scene = tests::referenceCase("pendulum-air").scene;
  for (const double share : {0.0, 0.05, 0.5}) {
    int calls = 0;
    const auto untilThen = [&](double done) {
      if (done >= share) ++calls;
      return done < share;
    };
    QVERIFY(!core::measure(scene, core::measuredSolvers(), 10, untilThen));
    // Whoever works is told once.
    QVERIFY(1 <= calls && calls <= 2);
  }
}

void MeasurementTest::progressRisesFromNothingToAll() {
  double latest = 0;
  bool rises = true;
  const auto watch = [&](double done) {
    rises = rises && latest <= done && done <= 1;
    latest = done;
    return true;
  };
  QVERIFY(core::measure(tests::referenceCase("pendulum-air").scene,
                        {{.method = "rk4", .step = 0.01}, {.method = "euler", .step = 0.01}}, 2,
                        watch));
  QVERIFY(rises);
  QVERIFY(std::abs(latest - 1) < 1e-9);
}

void MeasurementTest::aSceneWithoutWeightsHasNoErrors() {
  const auto measured =
      core::measure(std::make_shared<const core::Scene>(), {{.method = "rk4", .step = 0.125}}, 1);
  QCOMPARE(measured->until, 1.0);
  QCOMPARE(measured->curves[0].points[0].steps, std::int64_t{8});
  QCOMPARE(measured->curves[0].points[0].maxPositionError, 0.0);
}

QTEST_APPLESS_MAIN(MeasurementTest)
#include "measurement_test.moc"
