#include "core/run/polynomial.h"

#include <cmath>

#include <QtTest>

using core::FlightState;
using core::Polynomial;

namespace {

/// x = 1 + 2 t + 3 t⁴ over 2 s, in the first entry; the others stay zero.
Polynomial quartic() {
  Polynomial::Coefficients coefficients = Polynomial::Coefficients::Zero(5, 5);
  coefficients(0, 0) = 1;
  coefficients(0, 1) = 2 * 2;
  coefficients(0, 4) = 3 * 16;
  return {coefficients, 2};
}

/// Of the first entry from Hermite's cubic over [from, to], at its middle.
double departureFromCubic(const Polynomial& path, double from, double to) {
  const double h = to - from, middle = from + h / 2;
  const double cubic = 0.5 * (path.at(from)[0] + path.at(to)[0]) +
                       h / 8 * (path.rateAt(from)[0] - path.rateAt(to)[0]);
  return std::abs(path.at(middle)[0] - cubic);
}

}  // namespace

class PolynomialTest : public QObject {
  Q_OBJECT

 private slots:
  void countsTimeFromItsBegin();
  void knowsHowFarItIsFromCubics();
};

void PolynomialTest::countsTimeFromItsBegin() {
  const Polynomial path = quartic();
  QCOMPARE(path.at(0)[0], 1.0);
  QCOMPARE(path.at(1)[0], 6.0);
  QCOMPARE(path.rateAt(1)[0], 14.0);
  QCOMPARE(path.at(2)[0], 53.0);
  QCOMPARE(path.at(1)[3], 0.0);
}

void PolynomialTest::knowsHowFarItIsFromCubics() {
  const Polynomial path = quartic();
  // The bound of a quartic is met, at the middle: 24 · 3 h⁴ / 384.
  for (const double h : {2.0, 1.0, 0.25}) {
    QVERIFY(std::abs(path.bend(h)[0] - 72 * h * h * h * h / 384) < 1e-14);
    QVERIFY(std::abs(path.bend(h)[0] - departureFromCubic(path, 0, h)) < 1e-12);
  }
}

QTEST_APPLESS_MAIN(PolynomialTest)
#include "polynomial_test.moc"
