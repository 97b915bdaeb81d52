#include "core/recording/separation.h"

#include <cmath>
#include <memory>

#include <QtTest>

using core::Run;
using core::Scene;
using core::Separation;
using core::SeparationLog;

namespace {

constexpr double kGravity = 10;  // m/s²
constexpr double kRounding = 1e-12;

/// Weights that fall a long way without air: Runge–Kutta 4 is exact, Euler falls g h t/2 less.
Scene falling(int count) {
  Scene scene;
  scene.gravity = kGravity;
  scene.airDensity = 0;
  scene.room = {.width = 100, .height = 10000, .restitution = 1, .friction = 0};
  for (int i = 0; i < count; ++i) {
    core::Weight weight;
    weight.position = {1.0 + i, 9000};
    scene.weights.push_back(weight);
  }
  return scene;
}

/// Runs of one scene, advanced as the window does: always the one furthest behind.
class Runs {
 public:
  Runs(const Scene& scene, const std::vector<core::Solver>& solvers) {
    const auto shared = std::make_shared<const Scene>(scene);
    for (const core::Solver& solver : solvers) m_runs.emplace_back(shared, solver);
    for (const Run& run : m_runs) m_all.push_back(&run);
    log.start(m_all);
  }

  Run& operator[](std::size_t index) { return m_runs[index]; }

  void advanceTo(double time) {
    while (Run* behind = furthestBehind(time)) {
      behind->advance();
      log.note(m_all);
    }
  }

  SeparationLog log;

 private:
  Run* furthestBehind(double time) {
    Run* behind = nullptr;
    for (Run& run : m_runs) {
      if (run.status() != core::RunStatus::kRunning || run.time() >= time) continue;
      if (!behind || run.time() < behind->time()) behind = &run;
    }
    return behind;
  }

  std::vector<Run> m_runs;
  std::vector<const Run*> m_all;
};

const std::vector<core::Solver> kEulerAndRungeKutta = {{.method = "rk4", .step = 1.0 / 64},
                                                       {.method = "euler", .step = 1.0 / 16}};

}  // namespace

/// How far runs are apart.
class SeparationTest : public QObject {
  Q_OBJECT

 private slots:
  void isTheLargestDistanceOfTheSameWeight();
  void isZeroWithoutWeights();
  void growsAsWorkedOutByHand();
  void takesASampleAtEachEndOfTheLargestStep();
  void doesNotDependOnHowTimeIsCut();
  void comparesEachRunWithEach();
  void comparesNoRunThatHasStopped();
  void forgetsTheFuture();
};

void SeparationTest::isTheLargestDistanceOfTheSameWeight() {
  Scene scene = falling(3);
  scene.weights[1].velocity = {0, 5};  // gains on the others in neither run
  scene.gravity = 0;
  const auto apart = [&](double shift) {
    Scene other = scene;
    other.weights[2].position.x() += shift;
    other.weights[0].position.y() += 0.3;
    const Run a(std::make_shared<const Scene>(scene), {});
    const Run b(std::make_shared<const Scene>(other), {});
    return core::separationOf(a, b, 0);
  };
  QCOMPARE(apart(0.5).weight, 2);
  QCOMPARE(apart(0.5).distance, 0.5);
  QCOMPARE(apart(0.1).weight, 0);
  QVERIFY(std::abs(apart(0.1).distance - 0.3) < 1e-11);  // places are 9 km up
}

void SeparationTest::isZeroWithoutWeights() {
  Runs runs(falling(0), kEulerAndRungeKutta);
  const Separation none = core::separationOf(runs[0], runs[1], 0);
  QCOMPARE(none.weight, -1);
  QCOMPARE(none.distance, 0.0);
}

void SeparationTest::growsAsWorkedOutByHand() {
  Runs runs(falling(2), kEulerAndRungeKutta);
  runs.advanceTo(2);
  const double step = 1.0 / 16;
  for (const Separation& sample : runs.log.between(0, 1).samples())
    QVERIFY(std::abs(sample.distance - kGravity * step * sample.time / 2) < 1e4 * kRounding);
  QVERIFY(runs.log.between(0, 1).samples().size() > 30);
}

void SeparationTest::takesASampleAtEachEndOfTheLargestStep() {
  Runs runs(falling(1), kEulerAndRungeKutta);
  runs.advanceTo(0.5);
  const auto samples = runs.log.between(0, 1).samples();
  QCOMPARE(samples.size(), std::size_t{9});
  for (std::size_t i = 0; i < samples.size(); ++i)
    QCOMPARE(samples[i].time, static_cast<double>(i) / 16);
}

void SeparationTest::doesNotDependOnHowTimeIsCut() {
  // Steps that have no moment but the start in common.
  const std::vector<core::Solver> solvers = {{.method = "rk4", .step = 0.0137},
                                             {.method = "euler", .step = 0.01}};
  Runs atOnce(falling(1), solvers), inPieces(falling(1), solvers);
  atOnce.advanceTo(1);
  for (int i = 1; i <= 1000; ++i) inPieces.advanceTo(i / 1000.0);
  const auto all = atOnce.log.between(0, 1).samples();
  const auto same = inPieces.log.between(0, 1).samples();
  QCOMPARE(all.size(), same.size());
  QVERIFY(all.size() > 70);
  for (std::size_t i = 0; i < all.size(); ++i) {
    QCOMPARE(all[i].time, same[i].time);
    QCOMPARE(all[i].distance, same[i].distance);
  }
}

void SeparationTest::comparesEachRunWithEach() {
  Runs runs(falling(1), {{.method = "rk4", .step = 1.0 / 16},
                         {.method = "euler", .step = 1.0 / 16},
                         {.method = "euler", .step = 1.0 / 32}});
  runs.advanceTo(1);
  const auto last = [&](std::size_t a, std::size_t b) {
    return runs.log.between(a, b).samples().back().distance;
  };
  QVERIFY(std::abs(last(0, 1) - kGravity / 32) < 1e4 * kRounding);
  QVERIFY(std::abs(last(2, 0) - kGravity / 64) < 1e4 * kRounding);
  QVERIFY(std::abs(last(1, 2) - kGravity / 64) < 1e4 * kRounding);
  QCOMPARE(last(2, 1), last(1, 2));
}

void SeparationTest::comparesNoRunThatHasStopped() {
  Scene scene = falling(1);
  scene.airDensity = 30;  // Euler's step is far too large for air that thick
  scene.weights[0].mass = 1e-3;
  scene.weights[0].velocity = {0, -100};
  Runs runs(scene, {{.method = "rk4", .step = 1.0 / 4096},
                    {.method = "euler", .step = 1.0 / 16},
                    {.method = "rk4", .step = 1.0 / 2048}});
  runs.advanceTo(1);
  QCOMPARE(runs[1].status(), core::RunStatus::kDiverged);
  const double stopped = runs[1].time();
  QVERIFY(stopped < 0.9);
  QVERIFY(runs.log.between(0, 1).samples().back().time <= stopped);
  QCOMPARE(runs.log.between(0, 2).samples().back().time, 1.0);
}

void SeparationTest::forgetsTheFuture() {
  Runs runs(falling(1), kEulerAndRungeKutta);
  runs.advanceTo(1);
  runs.log.dropAfter(0.5);
  QCOMPARE(runs.log.between(0, 1).samples().back().time, 0.5);
  runs.advanceTo(2);
  const auto samples = runs.log.between(0, 1).samples();
  QCOMPARE(samples[9].time, 1.0);  // nothing was noted between
  QCOMPARE(samples[10].time, 1.0625);
}

QTEST_APPLESS_MAIN(SeparationTest)
#include "separation_test.moc"
