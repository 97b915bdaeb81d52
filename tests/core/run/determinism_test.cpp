#include <algorithm>
#include <memory>

#include <QtTest>

#include "core/run/run_state.h"
#include "tests/support/fingerprint.h"
#include "tests/support/random_scene.h"

using core::Run;
using core::RunStatus;
using tests::fingerprint;

namespace {

constexpr int kSteps = 150;

bool hasEventAt(const Run& run, int weight, double time) {
  return std::ranges::any_of(run.stepEvents(), [&](const core::Event& event) {
    return event.time == time && (event.weight == weight || event.other == weight);
  });
}

}  // namespace

class DeterminismTest : public QObject {
  Q_OBJECT

 private slots:
  void givesTheSameBitsTwice_data();
  void givesTheSameBitsTwice();
  void isNotChangedByBeingLookedAt_data();
  void isNotChangedByBeingLookedAt();
  void goesOnFromAStateWithTheSameBits_data();
  void goesOnFromAStateWithTheSameBits();
  void agreesWithItsPathsAtBothEndsOfAStep_data();
  void agreesWithItsPathsAtBothEndsOfAStep();

 private:
  void addRuns();
  Run newRun() const;
};

void DeterminismTest::addRuns() {
  QTest::addColumn<QByteArray>("method");
  QTest::addColumn<int>("seed");
  for (const std::string method : {"euler", "semi-implicit-euler", "rk4", "dopri5", "reference"})
    for (int seed = 0; seed < 6; ++seed)
      QTest::addRow("%s, %d", method.c_str(), seed) << QByteArray::fromStdString(method) << seed;
}

Run DeterminismTest::newRun() const {
  QFETCH(QByteArray, method);
  QFETCH(int, seed);
  return Run(std::make_shared<const core::Scene>(tests::randomScene(seed, 12)),
             {.method = method.toStdString(), .step = 1.0 / 60});
}

void DeterminismTest::givesTheSameBitsTwice_data() {
  addRuns();
}

void DeterminismTest::givesTheSameBitsTwice() {
  Run once = newRun(), again = newRun();
  for (int i = 0; i < kSteps; ++i) {
    QCOMPARE(once.advance(), RunStatus::kRunning);
    again.advance();
    QVERIFY(fingerprint(once) == fingerprint(again));
  }
}

void DeterminismTest::isNotChangedByBeingLookedAt_data() {
  addRuns();
}

void DeterminismTest::isNotChangedByBeingLookedAt() {
  Run watched = newRun(), alone = newRun();
  for (int i = 0; i < kSteps; ++i) {
    QCOMPARE(watched.advance(), RunStatus::kRunning);
    alone.advance();
    const double h = watched.solver().step;
    for (double share = 0; share <= 1; share += 0.125) {
      const double time = watched.time() - share * h;
      for (int w = 0; w < watched.weightCount(); ++w)
        QVERIFY(watched.weightAt(w, time).position.allFinite());
      QVERIFY(watched.energiesAt(time).kinetic >= 0);
    }
    QVERIFY(watched.state().bytes() > 0);
    QVERIFY(fingerprint(watched) == fingerprint(alone));
  }
}

void DeterminismTest::goesOnFromAStateWithTheSameBits_data() {
  addRuns();
}

void DeterminismTest::goesOnFromAStateWithTheSameBits() {
  Run run = newRun(), resumed = newRun();
  for (int i = 0; i < 40; ++i) run.advance();
  resumed.restore(run.state());
  QCOMPARE(resumed.stepCount(), run.stepCount());
  for (int i = 0; i < kSteps; ++i) {
    QCOMPARE(run.advance(), RunStatus::kRunning);
    resumed.advance();
    QVERIFY(fingerprint(run) == fingerprint(resumed));
  }
}

void DeterminismTest::agreesWithItsPathsAtBothEndsOfAStep_data() {
  addRuns();
}

void DeterminismTest::agreesWithItsPathsAtBothEndsOfAStep() {
  Run run = newRun();
  for (int i = 0; i < kSteps; ++i) {
    std::vector<Eigen::Vector2d> before;
    for (int w = 0; w < run.weightCount(); ++w) before.push_back(run.weight(w).position);
    const double start = run.time();
    QCOMPARE(run.advance(), RunStatus::kRunning);
    for (int w = 0; w < run.weightCount(); ++w) {
      // An event at that moment is over: a rope that Euler's path stretched is taut again.
      if (!hasEventAt(run, w, start)) QCOMPARE(run.weightAt(w, start).position, before[w]);
      QCOMPARE(run.weightAt(w, run.time()).position, run.weight(w).position);
    }
  }
}

QTEST_APPLESS_MAIN(DeterminismTest)
#include "determinism_test.moc"
