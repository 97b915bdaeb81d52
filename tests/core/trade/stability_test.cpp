#include "core/trade/stability.h"

#include <cmath>
#include <memory>
#include <optional>

#include <QtTest>

#include "core/run/run.h"
#include "tests/support/thick_air.h"

using core::largestStableStep;
using core::Run;
using core::RunStatus;
using core::Solver;

namespace {

constexpr double kSpeed = tests::kThickAirSpeed;

RunStatus endOf(const Solver& solver, double until) {
  Run run(tests::thickAir(), solver);
  while (run.time() < until && run.advance() == RunStatus::kRunning) {
  }
  return run.status();
}

}  // namespace

class StabilityTest : public QObject {
  Q_OBJECT

 private slots:
  void findsTheLimitOfEuler_data();
  void findsTheLimitOfEuler();
  void suggestsAStepThatWorks();
  void suggestsNothingWhereThereIsNoTime();
};

void StabilityTest::findsTheLimitOfEuler_data() {
  QTest::addColumn<double>("step");
  for (const double step : {0.068, 0.07, 0.1, 0.5, 3.0, 10.0}) QTest::addRow("%g s", step) << step;
}

void StabilityTest::findsTheLimitOfEuler() {
  QFETCH(double, step);
  const std::optional<double> stable =
      largestStableStep(tests::thickAir(), {.method = "euler", .step = step}, 1000);
  QVERIFY(stable);
  // 2 / 30 s, down to two digits; six bisections may leave a digit more.
  QVERIFY(*stable <= 2 / kSpeed);
  QVERIFY2(*stable > 2 / kSpeed - 0.003, qPrintable(QString::number(*stable, 'g', 17)));
  QVERIFY(std::abs(*stable * 1000 - std::round(*stable * 1000)) < 1e-12);
}

void StabilityTest::suggestsAStepThatWorks() {
  const Solver solver{.method = "rk4", .step = 0.5};
  QCOMPARE(endOf(solver, 1000), RunStatus::kDiverged);
  const std::optional<double> stable = largestStableStep(tests::thickAir(), solver, 1000);
  QVERIFY(stable);
  QCOMPARE(endOf({.method = "rk4", .step = *stable}, 1000), RunStatus::kRunning);
}

void StabilityTest::suggestsNothingWhereThereIsNoTime() {
  // 10⁶ s of steps below 0.07 s would be too much work for a suggestion.
  QVERIFY(!largestStableStep(tests::thickAir(), {.method = "euler", .step = 0.1}, 1e6));
}

QTEST_APPLESS_MAIN(StabilityTest)
#include "stability_test.moc"
