#include "core/motion/sine.h"

#include <cmath>
#include <numbers>

#include <QtTest>

using core::Lanes;

namespace {

/// How far sine(x) is from the exact value, in units of the last place of the result.
double unitsOff(double x) {
  // The long double of this machine has 11 bits more; its own rounding counts as nothing.
  const long double exact = std::sin(static_cast<long double>(x));
  int exponent = 0;
  (void)std::frexp(static_cast<double>(exact), &exponent);
  const auto error = static_cast<double>(core::sine(x) - exact);
  return std::abs(error) / std::ldexp(1.0, exponent - 53);
}

/// Largest of unitsOff() over many angles up to `range`, evenly spread.
double worstUpTo(double range) {
  constexpr int kAngles = 200'000;
  double worst = 0;
  for (int i = -kAngles; i <= kAngles; ++i)
    worst = std::max(worst, unitsOff(range * (i + 0.37) / kAngles));
  return worst;
}

}  // namespace

class SineTest : public QObject {
  Q_OBJECT

 private slots:
  void isRightToOneUnitInTheLastPlace_data();
  void isRightToOneUnitInTheLastPlace();
  void isRightNextToItsZerosAndPeaks();
  void keepsSignsAndWhatIsNotANumber();
  void givesABatchTheBitsOfSingleAngles();
};

void SineTest::isRightToOneUnitInTheLastPlace_data() {
  QTest::addColumn<double>("range");
  for (const double range : {1e-3, 0.8, 7.0, 1000.0, 8191.0, 1e7})
    QTest::addRow("up to %g rad", range) << range;
}

void SineTest::isRightToOneUnitInTheLastPlace() {
  QFETCH(double, range);
  if (std::numeric_limits<long double>::digits < 64) QSKIP("no wider number to compare with");
  const double worst = worstUpTo(range);
  // At best half a unit: the result is rounded.
  QVERIFY2(worst <= 1 && worst > 0.4, qPrintable(QString::number(worst)));
}

void SineTest::isRightNextToItsZerosAndPeaks() {
  if (std::numeric_limits<long double>::digits < 64) QSKIP("no wider number to compare with");
  // Up to here the last digits of the long double's own π do not show.
  for (int quarter = 1; quarter <= 200; ++quarter) {
    const double x = quarter * (std::numbers::pi / 2);
    for (const double next : {x, std::nextafter(x, 0), std::nextafter(x, 1e9)})
      QVERIFY2(unitsOff(next) <= 1, qPrintable(QString::number(next, 'g', 17)));
  }
  // sin of the double nearest π: π − that double.
  QCOMPARE(core::sine(std::numbers::pi), 1.2246467991473532e-16);
}

void SineTest::keepsSignsAndWhatIsNotANumber() {
  QCOMPARE(core::sine(0.0), 0.0);
  QCOMPARE(core::sine(-0.7), -core::sine(0.7));
  QCOMPARE(core::sine(5e-324), 5e-324);
  QVERIFY(std::isnan(core::sine(std::numeric_limits<double>::infinity())));
  QVERIFY(std::isnan(core::sine(std::numeric_limits<double>::quiet_NaN())));
}

void SineTest::givesABatchTheBitsOfSingleAngles() {
  // The last batch has one angle too large for the series among others that are not.
  for (const double scale : {0.01, 1.0, 900.0, 3000.0}) {
    Lanes angles;
    for (int i = 0; i < Lanes::kCount; ++i) angles.set(i, scale * (0.37 * i - 1));
    const Lanes sines = core::sine(angles);
    for (int i = 0; i < Lanes::kCount; ++i) QCOMPARE(sines[i], core::sine(angles[i]));
  }
}

QTEST_APPLESS_MAIN(SineTest)
#include "sine_test.moc"
