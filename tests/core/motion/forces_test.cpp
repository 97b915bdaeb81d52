#include "core/motion/forces.h"

#include <cmath>
#include <memory>
#include <numbers>

#include <QtTest>

#include "core/run/run.h"

using Eigen::Vector2d;

namespace {

core::Weight ball() {
  core::Weight weight;
  weight.mass = 2;
  weight.radius = 0.1;
  weight.dragCoefficient = 0.5;
  return weight;
}

/// What all forces together do to a weight of this run now [N].
Vector2d sumOfForces(const core::Run& run) {
  const core::Scene& scene = run.scene();
  const core::Weight& weight = scene.weights[0];
  const core::WeightState state = run.weight(0);
  Vector2d sum = core::gravityOn(weight, scene.gravity) +
                 core::dragOn(weight, scene.airDensity, state.velocity);
  if (weight.rope) sum += core::tensionOn(weight.rope->pivot, state.position, state.tension);
  return sum;
}

}  // namespace

class ForcesTest : public QObject {
  Q_OBJECT

 private slots:
  void gravityPullsDownWithTheWeight();
  void dragGrowsWithTheSquareOfTheSpeedAgainstIt();
  void dragHoldsTheWeightAtTheTerminalSpeed();
  void ropesPullTowardsThePivotAndRodsMayPush();
  void togetherTheyMoveTheWeight_data();
  void togetherTheyMoveTheWeight();
};

void ForcesTest::gravityPullsDownWithTheWeight() {
  QCOMPARE(core::gravityOn(ball(), 9.81), Vector2d(0, -19.62));
}

void ForcesTest::dragGrowsWithTheSquareOfTheSpeedAgainstIt() {
  // ½ · 1.2 · 0.5 · π 0.1² · 5² against (3, 4)/5
  const double size = 0.5 * 1.2 * 0.5 * std::numbers::pi * 0.01 * 25;
  const Vector2d drag = core::dragOn(ball(), 1.2, {3, 4});
  QVERIFY((drag - size * Vector2d(-0.6, -0.8)).norm() < 1e-15);  // some roundings of 0.2 N
  QCOMPARE(core::dragOn(ball(), 1.2, {0, 0}), Vector2d(0, 0));
}

void ForcesTest::dragHoldsTheWeightAtTheTerminalSpeed() {
  const double terminal = std::sqrt(9.81 / core::dragFactor(ball(), 1.2));
  const Vector2d sum = core::gravityOn(ball(), 9.81) + core::dragOn(ball(), 1.2, {0, -terminal});
  QVERIFY(sum.norm() < 1e-13);  // some roundings of 20 N
}

void ForcesTest::ropesPullTowardsThePivotAndRodsMayPush() {
  QCOMPARE(core::tensionOn({1, 5}, {1, 2}, 7), Vector2d(0, 7));
  QCOMPARE(core::tensionOn({1, 5}, {1, 6}, -7), Vector2d(0, 7));
}

void ForcesTest::togetherTheyMoveTheWeight_data() {
  QTest::addColumn<bool>("hangs");
  QTest::newRow("in flight") << false;
  QTest::newRow("on a rope") << true;
}

/// Newton's second law between the runs' own velocities.
void ForcesTest::togetherTheyMoveTheWeight() {
  QFETCH(bool, hangs);
  core::Scene scene;
  scene.airDensity = 50;  // so that drag matters
  scene.weights = {ball()};
  core::Weight& weight = scene.weights[0];
  weight.position = {2, 1.5};
  weight.velocity = {3, 2};
  if (hangs) weight.rope = core::Rope{{2, 2}, 1.2, 0.7, 2.5, false};
  const double h = 1e-3;
  core::Run run(std::make_shared<const core::Scene>(scene), {.method = "rk4", .step = h});
  const Vector2d before = run.weight(0).velocity;
  run.advance();
  const Vector2d sum = sumOfForces(run);
  run.advance();
  const Vector2d pull = weight.mass * (run.weight(0).velocity - before) / (2 * h);
  // The middle of two steps is off by v''' h²/6, some 1e2 N/s² · 1e-6 s².
  QVERIFY2((pull - sum).norm() < 1e-4 * sum.norm(),
           qPrintable(QString::number((pull - sum).norm() / sum.norm())));
}

QTEST_GUILESS_MAIN(ForcesTest)
#include "forces_test.moc"
