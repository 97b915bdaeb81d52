#include <cmath>
#include <memory>

#include <QtTest>

#include "core/motion/drag.h"
#include "tests/support/observed_order.h"

using tests::OrderMeasurement;

namespace {

/// A light weight thrown straight up at 5 m/s.
core::Scene tossed() {
  core::Scene scene;
  scene.weights.resize(1);
  scene.weights[0].mass = 0.0027;
  scene.weights[0].position = {2, 1};
  scene.weights[0].velocity = {0, 5};
  return scene;
}

/// Its height in closed form, with V = √(g/q): v = V tan(…) on the way up, −V tanh(…) down.
double tossedHeight(const core::Scene& scene, double time) {
  const double q = core::dragFactor(scene.weights[0], scene.airDensity);
  const double g = scene.gravity, terminal = std::sqrt(g / q);
  const double speed = scene.weights[0].velocity.y();
  const double up = terminal / g * std::atan(speed / terminal);
  const double top = std::log1p(speed * speed * q / g) / (2 * q);
  return 1 + top - std::log(std::cosh(g * (time - up) / terminal)) / q;
}

}  // namespace

/// How the errors of whole runs fall with the step, impacts, cuts and ropes included.
class OrderTest : public QObject {
  Q_OBJECT

 private slots:
  void convergesAtExactlyTheStatedOrder_data();
  void convergesAtExactlyTheStatedOrder();
  void keepsTheOrderAtStepsThatMeetNoEventOrMoment_data();
  void keepsTheOrderAtStepsThatMeetNoEventOrMoment();
  void keepsTheOrderOverTheTopOfAThrow();
};

void OrderTest::convergesAtExactlyTheStatedOrder_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("method");
  QTest::addColumn<double>("coarsest");
  // All moments fall on the ends of steps. Errors of Runge–Kutta lie between 10⁻⁹ m and
  // 10⁻¹² m here: below, rounding shows; above, the next powers of the step do.
  for (const char* name : {"cut-and-bounce", "pendulum-air", "pendulum-vacuum-60", "projectile-air",
                           "rope-goes-slack", "two-ropes-collide"}) {
    QTest::addRow("%s, rk4", name) << name << "rk4" << 1.0 / 240;
    QTest::addRow("%s, euler", name) << name << "euler" << 1.0 / 2560;
    QTest::addRow("%s, semi-implicit-euler", name) << name << "semi-implicit-euler" << 1.0 / 2560;
  }
  // What Runge–Kutta gets wrong in the swing's height, of order 5, outweighs what it gets
  // wrong in its time, of order 4, at all but small steps.
  QTest::newRow("pendulum-vacuum-120, rk4") << "pendulum-vacuum-120"
                                            << "rk4" << 1.0 / 640;
  // Euler's pendulum turns over the top at any but small steps.
  QTest::newRow("pendulum-vacuum-120, euler") << "pendulum-vacuum-120"
                                              << "euler" << 1.0 / 10240;
  QTest::newRow("pendulum-vacuum-120, semi-implicit-euler") << "pendulum-vacuum-120"
                                                            << "semi-implicit-euler" << 1.0 / 10240;
  // The weight is looked at just after its ninth bounce: where Euler's tenth comes early, or
  // its ninth late, the error is another one. Not so at small steps.
  QTest::newRow("bounce-vacuum, euler") << "bounce-vacuum"
                                        << "euler" << 1.0 / 40960;
  QTest::newRow("bounce-vacuum, semi-implicit-euler") << "bounce-vacuum"
                                                      << "semi-implicit-euler" << 1.0 / 40960;
}

void OrderTest::convergesAtExactlyTheStatedOrder() {
  QFETCH(QString, name);
  QFETCH(QString, method);
  QFETCH(double, coarsest);
  const core::Method& row = *core::findMethod(method.toStdString());
  const OrderMeasurement measured =
      measuredOrder(tests::referenceCase(name), row, {coarsest, coarsest / 1.5, coarsest / 2});
  QVERIFY2(std::abs(measured.order() - row.order) <= 0.1, qPrintable(measured.text()));
}

void OrderTest::keepsTheOrderAtStepsThatMeetNoEventOrMoment_data() {
  QTest::addColumn<QString>("name");
  QTest::newRow("through bounces") << "cut-and-bounce";
  QTest::newRow("through turning points in air") << "pendulum-air";
  QTest::newRow("through slack and taut") << "rope-goes-slack";
  QTest::newRow("through a collision on ropes") << "two-ropes-collide";
}

void OrderTest::keepsTheOrderAtStepsThatMeetNoEventOrMoment() {
  QFETCH(QString, name);
  // A place read from within a step adds an error of order 4 of its own, which is zero where
  // the moment falls on a step's end: seven steps even that out.
  const OrderMeasurement measured =
      measuredOrder(tests::referenceCase(name), *core::findMethod("rk4"),
                    tests::stepLadder(1.0 / 41, 1.0 / 331, 7));
  QVERIFY2(std::abs(measured.order() - 4) <= 0.2, qPrintable(measured.text()));
}

void OrderTest::keepsTheOrderOverTheTopOfAThrow() {
  // Straight up in air: |v| v has a kink at the top, where the step is split.
  tests::ReferenceCase toss{"throw", std::make_shared<core::Scene>(tossed()), {}};
  toss.exact.moments.resize(1);
  toss.exact.moments[0].time = 1;
  toss.exact.moments[0].weights.resize(1);
  toss.exact.moments[0].weights[0].position = {2, tossedHeight(*toss.scene, 1)};
  const OrderMeasurement measured =
      measuredOrder(toss, *core::findMethod("rk4"), tests::stepLadder(1.0 / 40, 1.0 / 320, 7));
  QVERIFY2(std::abs(measured.order() - 4) <= 0.2, qPrintable(measured.text()));
}

QTEST_APPLESS_MAIN(OrderTest)
#include "order_test.moc"
