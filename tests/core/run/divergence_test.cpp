#include <cmath>
#include <memory>

#include <QtTest>

#include "core/run/run.h"
#include "core/run/run_state.h"
#include "tests/support/fingerprint.h"

using core::Run;
using core::RunStatus;
using core::Scene;

namespace {

/// A light, large weight that falls into thick air: Euler's drag turns it around, faster at
/// every step.
std::shared_ptr<const Scene> thickAir() {
  Scene scene;
  scene.airDensity = 1000;
  scene.room = {.width = 1e5, .height = 1e5, .restitution = 1, .friction = 0};
  scene.weights.resize(1);
  scene.weights[0].mass = 0.001;
  scene.weights[0].radius = 0.1;
  scene.weights[0].position = {5e4, 5e4};
  scene.weights[0].velocity = {30, 0};
  return std::make_shared<const Scene>(std::move(scene));
}

}  // namespace

/// Numbers that stop being numbers.
class DivergenceTest : public QObject {
  Q_OBJECT

 private slots:
  void endsWithTheLastFiniteState_data();
  void endsWithTheLastFiniteState();
  void canBeTakenBack();
  void settlesAtASmallStep();
  void isNotStoppedWhileItsNumbersAreFinite();
};

void DivergenceTest::endsWithTheLastFiniteState_data() {
  QTest::addColumn<QByteArray>("method");
  QTest::newRow("euler") << QByteArray("euler");
  QTest::newRow("rk4") << QByteArray("rk4");
}

void DivergenceTest::endsWithTheLastFiniteState() {
  QFETCH(QByteArray, method);
  Run run(thickAir(), {.method = method.toStdString(), .step = 0.1});
  std::vector<double> last = tests::fingerprint(run);
  int steps = 0;
  while (run.advance() == RunStatus::kRunning && steps < 1000) {
    last = tests::fingerprint(run);
    ++steps;
  }
  QCOMPARE(run.status(), RunStatus::kDiverged);
  QCOMPARE(run.stepCount(), std::int64_t{steps});
  QCOMPARE(run.time(), steps * 0.1);
  QVERIFY(run.weight(0).position.allFinite());
  QVERIFY(run.weight(0).velocity.allFinite());
  QVERIFY(std::isfinite(run.energies().accounted()));
  const core::WeightState kept = run.weight(0);
  QCOMPARE(run.advance(), RunStatus::kDiverged);
  QCOMPARE(run.weight(0).position, kept.position);
  QCOMPARE(run.weight(0).velocity, kept.velocity);
  QCOMPARE(kept.position.x(), last[3]);
  QCOMPARE(kept.velocity.x(), last[5]);
}

void DivergenceTest::canBeTakenBack() {
  Run run(thickAir(), {.method = "euler", .step = 0.1});
  const core::RunState start = run.state();
  while (run.advance() == RunStatus::kRunning) {
  }
  const std::int64_t steps = run.stepCount();
  run.restore(start);
  QCOMPARE(run.status(), RunStatus::kRunning);
  while (run.advance() == RunStatus::kRunning) {
  }
  QCOMPARE(run.stepCount(), steps);
}

void DivergenceTest::settlesAtASmallStep() {
  const std::shared_ptr<const Scene> scene = thickAir();
  Run run(scene, {.method = "euler", .step = 1e-6});
  while (run.time() < 0.01) QCOMPARE(run.advance(), RunStatus::kRunning);
  QVERIFY(run.weight(0).velocity.norm() < 30);
}

void DivergenceTest::isNotStoppedWhileItsNumbersAreFinite() {
  // A rod that Euler whirls ever faster, truthfully.
  Scene scene;
  scene.airDensity = 0;
  scene.weights.resize(1);
  scene.weights[0].rope = core::Rope{.pivot = {2, 1.5}, .length = 1, .angle = 2, .rigid = true};
  Run run(std::make_shared<const Scene>(scene), {.method = "euler", .step = 0.1});
  for (int i = 0; i < 2000; ++i) QCOMPARE(run.advance(), RunStatus::kRunning);
  QVERIFY(run.energies().numericalDrift > 10 * std::abs(run.startEnergy()));
}

QTEST_APPLESS_MAIN(DivergenceTest)
#include "divergence_test.moc"
