#include "core/motion/series.h"

#include <cmath>

#include <QtTest>

#include "core/motion/flight.h"
#include "core/motion/slide.h"
#include "core/motion/swing.h"

using core::Series;

namespace {

double valueAt(const Series& series, double time) {
  double value = 0;
  for (int k = core::kSeriesDegree; k >= 0; --k) value = value * time + series[k];
  return value;
}

double rateAt(const Series& series, double time) {
  double rate = 0;
  for (int k = core::kSeriesDegree; k >= 1; --k) rate = rate * time + k * series[k];
  return rate;
}

/// How far the polynomials are from solving their equations a little later: largest entry.
template <class State, class Motion>
double residual(const Motion& motion, const State& start, double time) {
  const auto series = motion.series(start);
  State state, rate;
  for (std::size_t i = 0; i < series.size(); ++i) {
    state[static_cast<int>(i)] = valueAt(series[i], time);
    rate[static_cast<int>(i)] = rateAt(series[i], time);
  }
  return (motion(state) - rate).abs().maxCoeff();
}

}  // namespace

/// The Taylor series of the equations of motion.
class SeriesTest : public QObject {
  Q_OBJECT

 private slots:
  void multipliesAndTakesRoots();
  void solvesTheEquationOfTheSwing_data();
  void solvesTheEquationOfTheSwing();
  void solvesTheEquationOfTheFlight_data();
  void solvesTheEquationOfTheFlight();
  void solvesTheEquationOfTheSlide();
  void setsOutTheWayTheWeightDoes();
};

void SeriesTest::multipliesAndTakesRoots() {
  Series a{}, b{}, product{}, root{};
  // 1/(1 − t) times 1 + t/2, and the root of its square.
  a.fill(1);
  b[0] = 1;
  b[1] = 0.5;
  for (int k = 0; k <= core::kSeriesDegree; ++k) product[k] = core::productTerm(a, b, k);
  QCOMPARE(product[0], 1.0);
  for (int k = 1; k <= core::kSeriesDegree; ++k) QCOMPARE(product[k], 1.5);
  Series square{};
  for (int k = 0; k <= core::kSeriesDegree; ++k) square[k] = core::productTerm(product, product, k);
  root[0] = 1;
  for (int k = 1; k <= core::kSeriesDegree; ++k) root[k] = core::rootTerm(square, root, k);
  for (int k = 1; k <= core::kSeriesDegree; ++k) QVERIFY(std::abs(root[k] - 1.5) < 1e-12);
}

void SeriesTest::solvesTheEquationOfTheSwing_data() {
  QTest::addColumn<double>("angle");
  QTest::addColumn<double>("rate");
  QTest::addColumn<double>("drag");
  QTest::newRow("from rest, no air") << 2.0 << 0.0 << 0.0;
  QTest::newRow("from rest in air") << 2.0 << 0.0 << 0.3;
  QTest::newRow("backwards in air") << 0.4 << -3.0 << 0.3;
  QTest::newRow("around in air") << -1.0 << 9.0 << 0.1;
}

void SeriesTest::solvesTheEquationOfTheSwing() {
  QFETCH(double, angle);
  QFETCH(double, rate);
  QFETCH(double, drag);
  const core::Swing<> swing(9.81, 1.3, 0.19, drag);
  // 1/50 s is a small part of all times in the motion: terms left out are below rounding.
  QVERIFY(residual(swing, core::SwingState<>(angle, rate, 0.5), 0.02) < 1e-13);
}

void SeriesTest::solvesTheEquationOfTheFlight_data() {
  QTest::addColumn<double>("sideways");
  QTest::addColumn<double>("up");
  QTest::addColumn<double>("drag");
  QTest::newRow("no air") << 3.0 << 2.0 << 0.0;
  QTest::newRow("in air") << 3.0 << 2.0 << 0.3;
  QTest::newRow("straight up") << 0.0 << 2.0 << 0.3;
  QTest::newRow("straight down") << 0.0 << -2.0 << 0.3;
  QTest::newRow("dropped") << 0.0 << 0.0 << 0.3;
}

void SeriesTest::solvesTheEquationOfTheFlight() {
  QFETCH(double, sideways);
  QFETCH(double, up);
  QFETCH(double, drag);
  const core::Flight<> flight(9.81, 0.19, drag);
  core::FlightState<> start;
  start << 1, 2, sideways, up, 0.5;
  QVERIFY(residual(flight, start, 0.02) < 1e-13);
}

void SeriesTest::solvesTheEquationOfTheSlide() {
  for (const double way : {1.0, -1.0}) {
    const core::Slide slide(2, way, 0.19, 0.3);
    QVERIFY(residual(slide, core::SlideState<>(1, 3 * way, 0.5), 0.02) < 1e-13);
  }
}

void SeriesTest::setsOutTheWayTheWeightDoes() {
  // Let go on either side: what the air takes is positive, and brakes.
  for (const double angle : {2.0, -2.0}) {
    const auto in = core::Swing<>(9.81, 1, 0.19, 0.3).series(core::SwingState<>(angle, 0, 0));
    const auto without = core::Swing<>(9.81, 1, 0.19, 0).series(core::SwingState<>(angle, 0, 0));
    QVERIFY(valueAt(in[2], 0.05) > 0);
    QVERIFY(std::abs(valueAt(in[1], 0.05)) < std::abs(valueAt(without[1], 0.05)));
  }
}

QTEST_APPLESS_MAIN(SeriesTest)
#include "series_test.moc"
