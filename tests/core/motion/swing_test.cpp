#include "core/motion/swing.h"

#include <cmath>
#include <numbers>

#include <QtTest>

#include "core/methods/rk4.h"
#include "core/motion/drag.h"

using core::Lanes;
using core::Swing;
using core::SwingState;

namespace {

/// A different weight in every lane.
struct Batch {
  Lanes length, mass, drag;
  SwingState<Lanes> state;

  Batch() {
    for (int i = 0; i < Lanes::kCount; ++i) {
      length.set(i, 0.3 + 0.17 * i);
      mass.set(i, 0.01 * (i + 1));
      drag.set(i, i == 3 ? 0 : 0.02 * (Lanes::kCount - i));
      core::setLane(state, i, SwingState<>(-3 + 0.81 * i, 2.5 - 0.77 * i, 0.1 * i));
    }
  }
};

}  // namespace

class SwingTest : public QObject {
  Q_OBJECT

 private slots:
  void agreesWithASlopeWorkedByHand();
  void isAtRestStraightDownAndStraightUp();
  void mirrorsLeftAndRight();
  void losesWhatTheAirTakes();
  void givesABatchTheBitsOfSingleWeights();
  void dragFactorAgreesWithAValueWorkedByHand();
};

void SwingTest::agreesWithASlopeWorkedByHand() {
  const Swing<> swing(/*gravity*/ 10, /*length*/ 2, /*mass*/ 0.5, /*drag*/ 0.3);
  const SwingState<> slope = swing(SwingState<>(std::numbers::pi / 6, -2, 7));
  // κ = q L = 0.6: ω' = −(10/2)·½ + 0.6·2·2, Q' = 0.5·0.6·2²·2³.
  QCOMPARE(slope[0], -2.0);
  QVERIFY(std::abs(slope[1] - (-0.1)) < 1e-15);
  QVERIFY(std::abs(slope[2] - 9.6) < 1e-14);
}

void SwingTest::isAtRestStraightDownAndStraightUp() {
  const Swing<> swing(9.81, 1, 0.19, 0.1);
  QVERIFY((swing(SwingState<>(0, 0, 3)) == 0).all());
  // π is rounded, so its sine is not quite zero.
  QVERIFY((swing(SwingState<>(std::numbers::pi, 0, 3)).abs() < 2e-15).all());
}

void SwingTest::mirrorsLeftAndRight() {
  const Swing<> swing(9.81, 0.7, 0.19, 0.4);
  const SwingState<> slope = swing(SwingState<>(0.6, 1.3, 2));
  const SwingState<> mirrored = swing(SwingState<>(-0.6, -1.3, 2));
  QCOMPARE(mirrored[0], -slope[0]);
  QCOMPARE(mirrored[1], -slope[1]);
  QCOMPARE(mirrored[2], slope[2]);
}

void SwingTest::losesWhatTheAirTakes() {
  const double g = 9.81, length = 1.4, mass = 0.19, angle = 0.8, omega = -2.3;
  const SwingState<> slope = Swing<>(g, length, mass, 0.25)(SwingState<>(angle, omega, 0));
  // d/dt (½ m L² ω² − m g L cos θ) + Q' = 0
  const double mechanical =
      mass * length * length * omega * slope[1] + mass * g * length * std::sin(angle) * slope[0];
  QVERIFY(slope[2] > 0);
  QVERIFY(std::abs(mechanical + slope[2]) < 1e-14 * std::abs(mechanical));
}

void SwingTest::givesABatchTheBitsOfSingleWeights() {
  const Batch batch;
  const double g = 9.81;
  const Swing<Lanes> swing(g, batch.length, batch.mass, batch.drag);
  const SwingState<Lanes> slope = swing(batch.state);
  const SwingState<Lanes> end = core::RungeKutta4::step(swing, batch.state, slope, 1.0 / 60).end;
  for (int i = 0; i < Lanes::kCount; ++i) {
    const Swing<> alone(g, batch.length[i], batch.mass[i], batch.drag[i]);
    const SwingState<> state = core::laneOf(batch.state, i);
    const SwingState<> itsSlope = alone(state);
    QVERIFY((itsSlope == core::laneOf(slope, i)).all());
    const SwingState<> itsEnd = core::RungeKutta4::step(alone, state, itsSlope, 1.0 / 60).end;
    QVERIFY((itsEnd == core::laneOf(end, i)).all());
  }
}

void SwingTest::dragFactorAgreesWithAValueWorkedByHand() {
  core::Weight weight;
  weight.mass = 0.5;
  weight.radius = 0.1;
  weight.dragCoefficient = 0.5;
  // 1.2 · 0.5 · π 0.01 / (2 · 0.5)
  QVERIFY(std::abs(core::dragFactor(weight, 1.2) - 0.006 * std::numbers::pi) < 1e-17);
  QCOMPARE(core::dragFactor(weight, 0), 0.0);
}

QTEST_APPLESS_MAIN(SwingTest)
#include "swing_test.moc"
