#include "core/scene/scene.h"

#include <numbers>

#include <QtTest>

namespace {

core::Weight hanging(double angle, double angularVelocity) {
  core::Weight weight;
  weight.rope = core::Rope{{1, 3}, 2, angle, angularVelocity, false};
  return weight;
}

// A few roundings of sine, cosine and two products of numbers below ten.
constexpr double kRounding = 1e-14;

}  // namespace

class SceneTest : public QObject {
  Q_OBJECT

 private slots:
  void aFreeWeightStartsWhereItIsPut();
  void aHangingWeightStartsOnItsCircle_data();
  void aHangingWeightStartsOnItsCircle();
};

void SceneTest::aFreeWeightStartsWhereItIsPut() {
  core::Weight weight;
  weight.position = {0.4, 1.5};
  weight.velocity = {-2, 3};
  QCOMPARE(core::startPosition(weight), Eigen::Vector2d(0.4, 1.5));
  QCOMPARE(core::startVelocity(weight), Eigen::Vector2d(-2, 3));
}

void SceneTest::aHangingWeightStartsOnItsCircle_data() {
  QTest::addColumn<double>("angle");
  QTest::addColumn<double>("x");
  QTest::addColumn<double>("y");
  QTest::addColumn<double>("vx");
  QTest::addColumn<double>("vy");
  const double root = std::numbers::sqrt3;
  const double third = std::numbers::pi / 3;
  // Rope of 2 m from (1, 3), turning at 5 rad/s: 10 m/s.
  QTest::newRow("straight down") << 0.0 << 1.0 << 1.0 << 10.0 << 0.0;
  QTest::newRow("level, east") << 1.5 * third << 3.0 << 3.0 << 0.0 << 10.0;
  QTest::newRow("60° west") << -third << 1 - root << 2.0 << 5.0 << -5 * root;
  QTest::newRow("120° east") << 2 * third << 1 + root << 4.0 << -5.0 << 5 * root;
}

void SceneTest::aHangingWeightStartsOnItsCircle() {
  QFETCH(double, angle);
  QFETCH(double, x);
  QFETCH(double, y);
  QFETCH(double, vx);
  QFETCH(double, vy);
  const core::Weight weight = hanging(angle, 5);
  QVERIFY((core::startPosition(weight) - Eigen::Vector2d(x, y)).norm() < kRounding);
  QVERIFY((core::startVelocity(weight) - Eigen::Vector2d(vx, vy)).norm() < kRounding);
}

QTEST_APPLESS_MAIN(SceneTest)
#include "scene_test.moc"
