#include <algorithm>
#include <cmath>
#include <memory>

#include <QtTest>

#include "tests/support/random_scene.h"
#include "tests/support/reference_case.h"

using core::Energies;
using core::Run;
using core::RunStatus;
using core::Scene;

namespace {

constexpr auto kLosses = {&Energies::lostToAir, &Energies::lostToImpacts, &Energies::lostToRopes,
                          &Energies::lostToFriction};

/// Start energy and what gravity could still give, to measure errors by.
double scaleOf(const Run& run) {
  double scale = run.startEnergy();
  for (const core::Weight& weight : run.scene().weights)
    scale += weight.mass * run.scene().gravity * run.scene().room.height;
  return scale;
}

/// Energy that events of the latest step took [J].
double listedLoss(const Run& run) {
  double lost = 0;
  for (const core::Event& event : run.stepEvents()) lost += event.energyLost;
  return lost;
}

/// Whether a weight came to rest on another in the latest step: unlike a bounce series on
/// the floor, that takes no energy of its own.
bool hasRestOnAnother(const Run& run) {
  return std::ranges::any_of(run.stepEvents(), [](const core::Event& event) {
    return event.kind == core::EventKind::kRest && event.energyLost == 0;
  });
}

}  // namespace

/// The energy ledger of whole runs.
class EnergyTest : public QObject {
  Q_OBJECT

 private slots:
  void closesForReferences_data();
  void closesForReferences();
  void closesForAnyScene_data();
  void closesForAnyScene();
  void neverGivesLostEnergyBack_data();
  void neverGivesLostEnergyBack();
  void countsEveryEventOnce_data();
  void countsEveryEventOnce();
  void closesInsideSteps();
  void showsWhatEulerGetsWrong();

 private:
  void addScenes();
  Run newRun(const QByteArray& method, double step) const;
};

void EnergyTest::addScenes() {
  QTest::addColumn<int>("seed");
  for (int seed = 0; seed < 12; ++seed) QTest::addRow("%d", seed) << seed;
}

Run EnergyTest::newRun(const QByteArray& method, double step) const {
  QFETCH(int, seed);
  return Run(std::make_shared<const Scene>(tests::randomScene(seed, 12)),
             {.method = method.toStdString(), .step = step});
}

void EnergyTest::closesForReferences_data() {
  QTest::addColumn<QString>("name");
  for (const QString& name : tests::referenceNames()) QTest::newRow(qPrintable(name)) << name;
}

void EnergyTest::closesForReferences() {
  QFETCH(QString, name);
  Run run(tests::referenceCase(name).scene, {.method = "rk4", .step = 1.0 / 240});
  while (run.time() < 5) {
    QCOMPARE(run.advance(), RunStatus::kRunning);
    QVERIFY(std::abs(run.energies().numericalDrift) < 1e-7 * run.startEnergy());
  }
}

void EnergyTest::closesForAnyScene_data() {
  addScenes();
}

void EnergyTest::closesForAnyScene() {
  Run run = newRun("rk4", 1.0 / 240);
  bool heaped = false;
  while (run.time() < 3) {
    QCOMPARE(run.advance(), RunStatus::kRunning);
    heaped = heaped || hasRestOnAnother(run);
    const double drift = std::abs(run.energies().numericalDrift) / scaleOf(run);
    // Weights that lean on each other move by steps of first order.
    QVERIFY2(drift < (heaped ? 0.01 : 1e-7),
             qPrintable(QStringLiteral("%1 at %2 s").arg(drift).arg(run.time())));
  }
}

void EnergyTest::neverGivesLostEnergyBack_data() {
  addScenes();
}

void EnergyTest::neverGivesLostEnergyBack() {
  for (const char* method : {"euler", "rk4"}) {
    Run run = newRun(method, 1.0 / 60);
    Energies before = run.energies();
    for (int i = 0; i < 180; ++i) {
      QCOMPARE(run.advance(), RunStatus::kRunning);
      const Energies now = run.energies();
      for (const auto loss : kLosses) QVERIFY(now.*loss >= before.*loss);
      for (const core::Event& event : run.stepEvents()) QVERIFY(event.energyLost >= 0);
      before = now;
    }
  }
}

void EnergyTest::countsEveryEventOnce_data() {
  closesForReferences_data();
}

void EnergyTest::countsEveryEventOnce() {
  QFETCH(QString, name);
  Run run(tests::referenceCase(name).scene, {.method = "rk4", .step = 1.0 / 60});
  double listed = 0;
  while (run.time() < 5) {
    run.advance();
    listed += listedLoss(run);
    const Energies now = run.energies();
    // Summed in another order.
    QVERIFY(std::abs(now.lostToImpacts + now.lostToRopes - listed) < 1e-14);
    QCOMPARE(now.accounted() - run.startEnergy(), now.numericalDrift);
  }
}

void EnergyTest::closesInsideSteps() {
  Run run(tests::referenceCase("cut-and-bounce").scene, {.method = "rk4", .step = 1.0 / 80});
  while (run.time() < 2.5) {
    run.advance();
    for (double share = 0; share <= 1; share += 0.0625) {
      const double time = run.time() - share / 80;
      // A path inside a step is right to h⁴.
      QVERIFY(std::abs(run.energiesAt(time).numericalDrift) < 1e-6 * run.startEnergy());
    }
  }
}

void EnergyTest::showsWhatEulerGetsWrong() {
  // Explicit Euler turns each swing through h on a tangent: the energy of a small swing grows
  // by the factor 1 + (g/L) h² a step.
  Scene scene = *tests::referenceCase("pendulum-vacuum-60").scene;
  scene.weights[0].rope->angle = 0.01;
  const double step = 1.0 / 100;
  Run run(std::make_shared<const Scene>(scene), {.method = "euler", .step = step});
  const double lowest = scene.weights[0].mass * scene.gravity * (50 - 1);
  const double swing = run.startEnergy() - lowest;
  for (int i = 0; i < 1000; ++i) run.advance();
  const double grown = run.energies().mechanical() - lowest;
  const double expected = swing * std::pow(1 + scene.gravity * step * step, 1000);
  // The swing is not infinitely small: sin θ is off by θ²/6.
  QVERIFY(std::abs(grown / expected - 1) < 1e-3);
  QCOMPARE(run.energies().numericalDrift, run.energies().mechanical() - run.startEnergy());
}

QTEST_APPLESS_MAIN(EnergyTest)
#include "energy_test.moc"
