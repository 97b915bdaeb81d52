#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <QtTest>

#include "core/run/run.h"
#include "tests/support/random_scene.h"

using core::Run;
using core::RunStatus;
using core::Scene;
using Eigen::Vector2d;

namespace {

/// How far the disc stands out of the room [m], negative inside.
double outside(const Vector2d& center, double radius, const core::Room& room) {
  return std::max({radius - center.x(), center.x() + radius - room.width, radius - center.y(),
                   center.y() + radius - room.height});
}

/// How far any two discs overlap at that moment of the latest step [m], negative if none do.
double overlap(const Run& run, double time) {
  double deepest = -1e9;
  const std::vector<core::Weight>& weights = run.scene().weights;
  for (int a = 0; a < run.weightCount(); ++a)
    for (int b = a + 1; b < run.weightCount(); ++b) {
      const Vector2d apart = run.weightAt(a, time).position - run.weightAt(b, time).position;
      deepest = std::max(deepest, weights[a].radius + weights[b].radius - apart.norm());
    }
  return deepest;
}

Run twoWeights(double gap, double speed, const QByteArray& method, double step) {
  Scene scene;
  scene.gravity = 0;
  scene.airDensity = 0;
  scene.room = {.width = 100, .height = 3, .restitution = 1, .friction = 0};
  scene.weights.resize(2);
  scene.weights[0].position = {50, 1};
  scene.weights[0].velocity = {speed, 0};
  scene.weights[1].position = {50.04 + gap, 1};
  scene.weights[1].velocity = {-speed, 0};
  return Run(std::make_shared<const Scene>(scene), {.method = method.toStdString(), .step = step});
}

}  // namespace

/// Weights are stopped by walls and by each other at any speed and step.
class RoomTest : public QObject {
  Q_OBJECT

 private slots:
  void keepsEveryWeightInside_data();
  void keepsEveryWeightInside();
  void keepsFastWeightsApart_data();
  void keepsFastWeightsApart();
  void hitsAWallThatARodJustReaches_data();
  void hitsAWallThatARodJustReaches();
  void keepsEveryWeightWithinItsRope_data();
  void keepsEveryWeightWithinItsRope();
  void pullsRopesTautWithoutAJump_data();
  void pullsRopesTautWithoutAJump();
};

void RoomTest::keepsEveryWeightInside_data() {
  QTest::addColumn<QByteArray>("method");
  QTest::addColumn<double>("step");
  QTest::addColumn<int>("seed");
  for (const std::string method : {"euler", "rk4"})
    for (const double step : {1.0 / 240, 1.0 / 60, 0.2})
      for (int seed = 0; seed < 12; ++seed)
        QTest::addRow("%s at %g s, %d", method.c_str(), step, seed)
            << QByteArray::fromStdString(method) << step << seed;
}

void RoomTest::keepsEveryWeightInside() {
  QFETCH(QByteArray, method);
  QFETCH(double, step);
  QFETCH(int, seed);
  const auto scene = std::make_shared<const Scene>(tests::randomScene(seed, 12));
  Run run(scene, {.method = method.toStdString(), .step = step});
  // On ropes the plane cubic of an arc of 0.12 rad is off by up to 10⁻⁶ of its length, and a
  // graze shallower than that may be overlooked.
  constexpr double kGraze = 1e-6;
  while (run.time() < 3) {
    const double start = run.time();
    QCOMPARE(run.advance(), RunStatus::kRunning);
    for (double share = 0.125; share <= 1; share += 0.125) {
      const double time = start + share * (run.time() - start);
      for (int i = 0; i < run.weightCount(); ++i) {
        const Vector2d place = run.weightAt(i, time).position;
        const double out = outside(place, scene->weights[i].radius, scene->room);
        QVERIFY2(out < kGraze,
                 qPrintable(QStringLiteral("%1 by %2 at %3").arg(i).arg(out).arg(time)));
      }
      const double deep = overlap(run, time);
      QVERIFY2(deep < kGraze, qPrintable(QStringLiteral("%1 at %2").arg(deep).arg(time)));
    }
  }
}

void RoomTest::keepsFastWeightsApart_data() {
  QTest::addColumn<QByteArray>("method");
  QTest::addColumn<double>("gap");
  QTest::addColumn<double>("speed");
  QTest::addColumn<double>("step");
  for (const std::string method : {"euler", "rk4"})
    for (const double gap : {0.01, 1.0})
      for (const double speed : {1.0, 1e5})
        for (const double step : {1e-6, 1.0 / 60, 1.0})
          QTest::addRow("%s, %g m, %g m/s at %g s", method.c_str(), gap, speed, step)
              << QByteArray::fromStdString(method) << gap << speed << step;
}

void RoomTest::keepsFastWeightsApart() {
  QFETCH(QByteArray, method);
  QFETCH(double, gap);
  QFETCH(double, speed);
  QFETCH(double, step);
  Run run = twoWeights(gap, speed, method, step);
  for (int i = 0; i < 20; ++i) {
    const double start = run.time();
    QCOMPARE(run.advance(), RunStatus::kRunning);
    for (double share = 0.125; share <= 1; share += 0.125) {
      const double time = start + share * (run.time() - start);
      const Vector2d apart = run.weightAt(1, time).position - run.weightAt(0, time).position;
      QVERIFY(apart.x() > 0.04 - 1e-9);
    }
  }
  QVERIFY(std::abs(run.energies().numericalDrift) < 1e-12 * run.startEnergy());
}

void RoomTest::hitsAWallThatARodJustReaches_data() {
  QTest::addColumn<double>("turn");
  for (const double turn : {0.03, 0.5, 1.1, 3.0, 20.0})
    QTest::addRow("%g rad a step", turn) << turn;
}

void RoomTest::hitsAWallThatARodJustReaches() {
  QFETCH(double, turn);
  // The circle reaches 0.1 mm behind the east wall, in the middle of the first step.
  Scene scene;
  scene.gravity = 0;
  scene.airDensity = 0;
  scene.weights.resize(1);
  scene.weights[0].rope = core::Rope{.pivot = {scene.room.width - 1.02 + 1e-4, 1.5},
                                     .length = 1,
                                     .angle = std::numbers::pi / 2 - std::min(turn / 2, 0.55),
                                     .angularVelocity = 2,
                                     .rigid = true};
  Run run(std::make_shared<const Scene>(scene), {.method = "rk4", .step = turn / 2});
  run.advance();
  QVERIFY(!run.stepEvents().empty());
  const core::Event hit = run.stepEvents()[0];
  QCOMPARE(hit.kind, core::EventKind::kImpactEast);
  const double angle = std::asin(1 - 1e-4);
  // The wall is met at a slope of 1/70, to 10⁻¹² m.
  QVERIFY(std::abs(hit.time - (angle - scene.weights[0].rope->angle) / 2) < 1e-10);
}

void RoomTest::keepsEveryWeightWithinItsRope_data() {
  QTest::addColumn<int>("seed");
  for (int seed = 0; seed < 12; ++seed) QTest::addRow("%d", seed) << seed;
}

void RoomTest::keepsEveryWeightWithinItsRope() {
  QFETCH(int, seed);
  const auto scene = std::make_shared<const Scene>(tests::randomScene(seed, 12));
  Run run(scene, {.method = "rk4", .step = 1.0 / 60});
  while (run.time() < 3 && !run.allCut()) {
    QCOMPARE(run.advance(), RunStatus::kRunning);
    for (int i = 0; i < run.weightCount(); ++i) {
      const core::WeightState state = run.weight(i);
      if (state.phase != core::Phase::kSlack) continue;
      const core::Rope& rope = *scene->weights[i].rope;
      // Within the tolerance of being taut.
      QVERIFY((state.position - rope.pivot).norm() <= rope.length + 1e-11);
    }
  }
}

void RoomTest::pullsRopesTautWithoutAJump_data() {
  QTest::addColumn<QByteArray>("method");
  QTest::addColumn<double>("most");
  QTest::newRow("rk4") << QByteArray("rk4") << 1e-11;
  // Straight paths leave a circle by (v h)² / (2 L) a step, a millimeter or two here.
  QTest::newRow("euler") << QByteArray("euler") << 0.004;
}

void RoomTest::pullsRopesTautWithoutAJump() {
  QFETCH(QByteArray, method);
  QFETCH(double, most);
  int counted = 0;
  for (int seed = 0; seed < 20; ++seed) {
    Scene scene = tests::randomScene(seed, 12);
    scene.cutTime.reset();
    Run run(std::make_shared<const Scene>(std::move(scene)),
            {.method = method.toStdString(), .step = 1.0 / 240});
    while (run.time() < 3) {
      QCOMPARE(run.advance(), RunStatus::kRunning);
      for (const core::Event& event : run.stepEvents()) {
        if (event.kind != core::EventKind::kTaut) continue;
        ++counted;
        const Vector2d after = run.weightAt(event.weight, event.time).position;
        QVERIFY2((after - event.position).norm() < most, qPrintable(QString::number(seed)));
      }
    }
  }
  QVERIFY(counted > 20);
}

QTEST_APPLESS_MAIN(RoomTest)
#include "room_test.moc"
