#include "core/trade/reference.h"

#include <cmath>

#include <QtTest>

#include "core/methods/method.h"
#include "core/run/run.h"
#include "core/scene/scene_limits.h"
#include "tests/support/reference_case.h"

using core::Run;
using core::RunStatus;
using tests::Course;
using tests::ReferenceCase;

class ReferenceTest : public QObject {
  Q_OBJECT

 private slots:
  void agreesWithEveryExactAnswer_data();
  void agreesWithEveryExactAnswer();
  void listsTheSameEventsAtTheSameMoments_data();
  void listsTheSameEventsAtTheSameMoments();
  void knowsWhereEveryJouleIs_data();
  void knowsWhereEveryJouleIs();
  void isCoarserAtTheCoarserTolerance();
  void crossesTheTopOfAThrowHoweverSteep_data();
  void crossesTheTopOfAThrowHoweverSteep();
  void losesNoEnergyInALongSwing();
  void isForTheProgramsOwnUse();

 private:
  void addReferences();
};

void ReferenceTest::addReferences() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<double>("step");
  for (const QString& name : tests::referenceNames())
    for (const double step : {1.0 / 60, 1.0})
      QTest::addRow("%s, looked at every %g s", qPrintable(name), step) << name << step;
}

void ReferenceTest::agreesWithEveryExactAnswer_data() {
  addReferences();
}

void ReferenceTest::agreesWithEveryExactAnswer() {
  QFETCH(QString, name);
  QFETCH(double, step);
  const ReferenceCase reference = tests::referenceCase(name);
  const double error = positionError(reference, simulated(reference, core::referenceSolver(step)));
  // What core/trade/reference.h says. Measured: 1.2·10⁻¹³ m, most of it the rounding of times.
  QVERIFY2(error <= core::kReferenceError, qPrintable(QString::number(error)));
}

void ReferenceTest::listsTheSameEventsAtTheSameMoments_data() {
  addReferences();
}

void ReferenceTest::listsTheSameEventsAtTheSameMoments() {
  QFETCH(QString, name);
  QFETCH(double, step);
  const ReferenceCase reference = tests::referenceCase(name);
  const Course course = simulated(reference, core::referenceSolver(step));
  QCOMPARE(course.events.size(), reference.exact.events.size());
  for (std::size_t i = 0; i < course.events.size(); ++i) {
    QCOMPARE(course.events[i].kind, reference.exact.events[i].kind);
    QCOMPARE(course.events[i].weight, reference.exact.events[i].weight);
    QCOMPARE(course.events[i].other, reference.exact.events[i].other);
    QVERIFY(std::abs(course.events[i].time - reference.exact.events[i].time) < 1e-12);
    QVERIFY(std::abs(course.events[i].energyLost - reference.exact.events[i].energyLost) < 1e-12);
  }
}

void ReferenceTest::knowsWhereEveryJouleIs_data() {
  addReferences();
}

void ReferenceTest::knowsWhereEveryJouleIs() {
  QFETCH(QString, name);
  QFETCH(double, step);
  const ReferenceCase reference = tests::referenceCase(name);
  const Course course = simulated(reference, core::referenceSolver(step));
  for (std::size_t i = 0; i < course.moments.size(); ++i) {
    const core::Energies& found = course.moments[i].energies;
    const core::Energies& exact = reference.exact.moments[i].energies;
    QVERIFY(std::abs(found.kinetic - exact.kinetic) < 1e-12);
    QVERIFY(std::abs(found.lostToAir - exact.lostToAir) < 1e-12);
    QVERIFY(std::abs(found.numericalDrift) < 1e-12);
  }
}

void ReferenceTest::isCoarserAtTheCoarserTolerance() {
  const ReferenceCase reference = tests::referenceCase("pendulum-vacuum-120");
  const auto error = [&](double tolerance) {
    return positionError(reference, simulated(reference, core::referenceSolver(1, tolerance)));
  };
  const double fine = error(core::kReferenceTolerance);
  const double coarse = error(core::kCoarseReferenceTolerance);
  QVERIFY2(coarse > 5 * fine && coarse < 1e-11, qPrintable(QString::number(coarse)));
}

void ReferenceTest::crossesTheTopOfAThrowHoweverSteep_data() {
  QTest::addColumn<double>("sideways");
  for (const double sideways : {0.0, 1e-12, 1e-8, 1e-6, 1e-3, 0.1})
    QTest::addRow("%g m/s sideways", sideways) << sideways;
}

void ReferenceTest::crossesTheTopOfAThrowHoweverSteep() {
  QFETCH(double, sideways);
  core::Scene scene;
  scene.weights.resize(1);
  scene.weights[0].mass = 0.0027;
  scene.weights[0].position = {2, 1};
  scene.weights[0].velocity = {sideways, 5};
  Run fine(std::make_shared<const core::Scene>(scene), core::referenceSolver(1));
  Run stepped(std::make_shared<const core::Scene>(scene), {.method = "rk4", .step = 1.0 / 50000});
  QCOMPARE(fine.advance(), RunStatus::kRunning);
  while (stepped.stepCount() < 50000) stepped.advance();
  // Runge–Kutta crosses all but the straight throw with its error of order 4, split or not.
  const double apart = (fine.weight(0).position - stepped.weight(0).position).norm();
  QVERIFY2(apart < 1e-11, qPrintable(QString::number(apart)));
  QVERIFY(fine.slopeEvaluations() < 200);
}

void ReferenceTest::losesNoEnergyInALongSwing() {
  Run run(tests::referenceCase("pendulum-vacuum-120").scene, core::referenceSolver(10));
  while (run.time() < 1000) QCOMPARE(run.advance(), RunStatus::kRunning);
  // 20 000 steps that round the energy in the last digit, as often up as down.
  QVERIFY(std::abs(run.energies().numericalDrift) < 1e-12 * run.startEnergy());
}

void ReferenceTest::isForTheProgramsOwnUse() {
  const core::Solver solver = core::referenceSolver(1.0 / 60);
  QVERIFY(core::isReference(solver));
  QVERIFY(!core::isReference({.method = "dopri5"}));
  QVERIFY(core::findMethod(solver.method) != nullptr);
  QVERIFY(core::findOfferedMethod(solver.method) == nullptr);
  for (const core::Method& method : core::methods()) QVERIFY(method.id != solver.method);
  core::Scene scene;
  scene.solvers = {solver, core::referenceSolver(10, core::kCoarseReferenceTolerance)};
  QVERIFY(core::problemsIn(scene).empty());
}

QTEST_APPLESS_MAIN(ReferenceTest)
#include "reference_test.moc"
