#include "core/scene/angle.h"

#include <limits>
#include <numbers>

#include <QtTest>

class AngleTest : public QObject {
  Q_OBJECT

 private slots:
  void aHalfTurnIsPi();
  void whatAUserWroteIsShownAgain_data();
  void whatAUserWroteIsShownAgain();
  void anAngleWrittenInDegreesReadsBackTheSame();
  void staysNonFinite();
};

void AngleTest::aHalfTurnIsPi() {
  QCOMPARE(core::radians(180), std::numbers::pi);
  QCOMPARE(core::radians(-90), -std::numbers::pi / 2);
  QCOMPARE(core::degrees(std::numbers::pi), 180.0);
}

void AngleTest::whatAUserWroteIsShownAgain_data() {
  QTest::addColumn<double>("written");
  QTest::newRow("whole") << 70.0;
  QTest::newRow("negative") << -33.0;
  QTest::newRow("decimals") << 0.123456789;
  QTest::newRow("tenths") << 12.7;
  QTest::newRow("fast") << -99999.9;
  QTest::newRow("zero") << 0.0;
}

void AngleTest::whatAUserWroteIsShownAgain() {
  QFETCH(double, written);
  QVERIFY(core::degrees(core::radians(written)) == written);
}

void AngleTest::anAngleWrittenInDegreesReadsBackTheSame() {
  // An irrational stride: every value has all digits a double can hold.
  for (int i = 0; i < 10000; ++i) {
    const double angle = core::radians(-180 + 0.0254 * std::numbers::sqrt2 * i);
    QVERIFY(core::radians(core::degrees(angle)) == angle);
  }
}

void AngleTest::staysNonFinite() {
  QVERIFY(qIsInf(core::degrees(std::numeric_limits<double>::infinity())));
  QVERIFY(qIsNaN(core::degrees(std::numeric_limits<double>::quiet_NaN())));
}

QTEST_APPLESS_MAIN(AngleTest)
#include "angle_test.moc"
