#include "core/motion/flight.h"

#include <cmath>

#include <QtTest>

#include "core/methods/rk4.h"

using core::Flight;
using core::FlightState;
using core::Lanes;

namespace {

FlightState<> stateOf(double vx, double vy) {
  FlightState<> state;
  state << 1, 2, vx, vy, 0;
  return state;
}

}  // namespace

class FlightTest : public QObject {
  Q_OBJECT

 private slots:
  void agreesWithASlopeWorkedByHand();
  void fallsFreelyWithoutDrag();
  void keepsItsTerminalSpeed();
  void followsTheFallInClosedForm();
  void slowsAgainstItsWholeVelocity();
  void losesWhatTheAirTakes();
  void givesABatchTheBitsOfSingleWeights();
};

void FlightTest::agreesWithASlopeWorkedByHand() {
  const FlightState<> slope = Flight<>(/*gravity*/ 10, /*mass*/ 0.5, /*drag*/ 0.2)(stateOf(3, -4));
  // |v| = 5: x'' = −0.2·5·3, y'' = −10 + 0.2·5·4, Q' = 0.5·0.2·5³.
  FlightState<> expected;
  expected << 3, -4, -3, -6, 12.5;
  QVERIFY(((slope - expected).abs() < 1e-14).all());
}

void FlightTest::fallsFreelyWithoutDrag() {
  FlightState<> expected;
  expected << 8, 9, 0, -9.81, 0;
  QVERIFY((Flight<>(9.81, 0.19, 0)(stateOf(8, 9)) == expected).all());
}

void FlightTest::keepsItsTerminalSpeed() {
  // √(g/q) = 8 m/s
  const FlightState<> slope = Flight<>(10.24, 2, 0.16)(stateOf(0, -8));
  QVERIFY(std::abs(slope[3]) < 1e-14);
}

void FlightTest::followsTheFallInClosedForm() {
  // Dropped from rest: v = −V tanh(g t / V), V = √(g/q), so v' = −g / cosh²(g t / V).
  const double g = 9.81, q = 0.13, terminal = std::sqrt(g / q);
  for (const double t : {0.0, 0.3, 1.0, 4.0}) {
    const double v = -terminal * std::tanh(g * t / terminal);
    const double cosh = std::cosh(g * t / terminal);
    QVERIFY(std::abs(Flight<>(g, 1, q)(stateOf(0, v))[3] + g / (cosh * cosh)) < 1e-14);
  }
}

void FlightTest::slowsAgainstItsWholeVelocity() {
  // Without gravity the drag is opposite to the velocity, of size q v², whatever the way.
  for (const double angle : {0.0, 0.7, 2.0, 4.5}) {
    const double speed = 3.5, q = 0.4;
    const FlightState<> slope =
        Flight<>(0, 1, q)(stateOf(speed * std::cos(angle), speed * std::sin(angle)));
    QVERIFY(std::abs(slope[2] + q * speed * speed * std::cos(angle)) < 1e-14);
    QVERIFY(std::abs(slope[3] + q * speed * speed * std::sin(angle)) < 1e-14);
  }
}

void FlightTest::losesWhatTheAirTakes() {
  const double g = 9.81, mass = 0.19, vx = 4, vy = -1.5;
  const FlightState<> slope = Flight<>(g, mass, 0.3)(stateOf(vx, vy));
  // d/dt (½ m v² + m g y) + Q' = 0
  const double mechanical = mass * (vx * slope[2] + vy * slope[3]) + mass * g * slope[1];
  QVERIFY(slope[4] > 0);
  QVERIFY(std::abs(mechanical + slope[4]) < 1e-14 * slope[4]);
}

void FlightTest::givesABatchTheBitsOfSingleWeights() {
  Lanes mass, drag;
  FlightState<Lanes> states;
  for (int i = 0; i < Lanes::kCount; ++i) {
    mass.set(i, 0.03 * (i + 1));
    drag.set(i, i == 5 ? 0 : 0.011 * i);
    FlightState<> state;
    state << 0.1 * i, 2 - 0.05 * i, 7 - 1.3 * i, -4 + 0.9 * i, 0.01 * i;
    core::setLane(states, i, state);
  }
  const Flight<Lanes> flight(9.81, mass, drag);
  const FlightState<Lanes> slope = flight(states);
  const FlightState<Lanes> end = core::RungeKutta4::step(flight, states, slope, 1.0 / 60).end;
  for (int i = 0; i < Lanes::kCount; ++i) {
    const Flight<> alone(9.81, mass[i], drag[i]);
    const FlightState<> state = core::laneOf(states, i);
    const FlightState<> itsSlope = alone(state);
    QVERIFY((itsSlope == core::laneOf(slope, i)).all());
    const FlightState<> itsEnd = core::RungeKutta4::step(alone, state, itsSlope, 1.0 / 60).end;
    QVERIFY((itsEnd == core::laneOf(end, i)).all());
  }
}

QTEST_APPLESS_MAIN(FlightTest)
#include "flight_test.moc"
