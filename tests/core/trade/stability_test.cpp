#include "core/trade/stability.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include <QtTest>

#include "core/run/run.h"

using core::largestStableStep;
using core::Run;
using core::RunStatus;
using core::Scene;
using core::Solver;

namespace {

constexpr double kSpeed = 30;  // [m/s]

/// A weight thrown into air of drag factor q = 1/m, without gravity: explicit Euler's speed
/// grows where |1 − q v h| > 1, at steps above 2 / (q v).
std::shared_ptr<const Scene> thickAir() {
  Scene scene;
  scene.gravity = 0;
  scene.airDensity = 1000;
  scene.room = {.width = 1e5, .height = 1e5, .restitution = 1, .friction = 0};
  scene.weights.resize(1);
  scene.weights[0].mass = 1;
  scene.weights[0].radius = 0.1;
  scene.weights[0].dragCoefficient = 0.2 / std::numbers::pi;
  scene.weights[0].position = {5e4, 5e4};
  scene.weights[0].velocity = {kSpeed, 0};
  return std::make_shared<const Scene>(std::move(scene));
}

RunStatus endOf(const Solver& solver, double until) {
  Run run(thickAir(), solver);
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
      largestStableStep(thickAir(), {.method = "euler", .step = step}, 1000);
  QVERIFY(stable);
  // 2 / 30 s, down to two digits; six bisections may leave a digit more.
  QVERIFY(*stable <= 2 / kSpeed);
  QVERIFY2(*stable > 2 / kSpeed - 0.003, qPrintable(QString::number(*stable, 'g', 17)));
  QVERIFY(std::abs(*stable * 1000 - std::round(*stable * 1000)) < 1e-12);
}

void StabilityTest::suggestsAStepThatWorks() {
  const Solver solver{.method = "rk4", .step = 0.5};
  QCOMPARE(endOf(solver, 1000), RunStatus::kDiverged);
  const std::optional<double> stable = largestStableStep(thickAir(), solver, 1000);
  QVERIFY(stable);
  QCOMPARE(endOf({.method = "rk4", .step = *stable}, 1000), RunStatus::kRunning);
}

void StabilityTest::suggestsNothingWhereThereIsNoTime() {
  // 10⁶ s of steps below 0.07 s would be too much work for a suggestion.
  QVERIFY(!largestStableStep(thickAir(), {.method = "euler", .step = 0.1}, 1e6));
}

QTEST_APPLESS_MAIN(StabilityTest)
#include "stability_test.moc"
