#include "ui/files/degree_text.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>

#include <QtTest>

#include "core/scene/angle.h"
#include "core/scene/scene_limits.h"

class DegreeTextTest : public QObject {
  Q_OBJECT

 private slots:
  void writesDegreesAsTheyWereSet();
  void readsBackTheSameAngle_data();
  void readsBackTheSameAngle();
  void readsNumbersInFullOrNotAtAll_data();
  void readsNumbersInFullOrNotAtAll();
};

void DegreeTextTest::writesDegreesAsTheyWereSet() {
  for (int thousandths = -180'000; thousandths <= 180'000; ++thousandths) {
    const std::string written = core::numberText(thousandths / 1000.0);
    QCOMPARE(ui::degreeText(ui::radiansFromDegreeText(written)), written);
  }
}

void DegreeTextTest::readsBackTheSameAngle_data() {
  QTest::addColumn<double>("largest");  // [rad]
  QTest::newRow("angles") << std::numbers::pi;
  QTest::newRow("small angles") << 1e-6;
  QTest::newRow("angular velocities") << core::radians(1e5);
}

void DegreeTextTest::readsBackTheSameAngle() {
  QFETCH(double, largest);
  std::mt19937_64 random(7);
  for (int i = 0; i < 20'000; ++i) {
    const double share = static_cast<double>(random()) / static_cast<double>(UINT64_MAX);
    const double angle = largest * (2 * share - 1);
    QCOMPARE(ui::radiansFromDegreeText(ui::degreeText(angle)), angle);
  }
  QCOMPARE(ui::radiansFromDegreeText(ui::degreeText(largest)), largest);
}

void DegreeTextTest::readsNumbersInFullOrNotAtAll_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<double>("number");  // NaN: refused
  const double refused = std::numeric_limits<double>::quiet_NaN();
  QTest::newRow("integer") << QByteArray("12") << 12.0;
  QTest::newRow("fraction") << QByteArray("-0.1") << -0.1;
  QTest::newRow("exponent") << QByteArray("1e-7") << 1e-7;
  QTest::newRow("empty") << QByteArray() << refused;
  QTest::newRow("decimal comma") << QByteArray("0,1") << refused;
  QTest::newRow("behind it") << QByteArray("1s") << refused;
  QTest::newRow("space before it") << QByteArray(" 1") << refused;
  QTest::newRow("infinity") << QByteArray("inf") << refused;
  QTest::newRow("not a number") << QByteArray("nan") << refused;
  QTest::newRow("too large") << QByteArray("1e999") << refused;
  QTest::newRow("hexadecimal") << QByteArray("0x10") << refused;
}

void DegreeTextTest::readsNumbersInFullOrNotAtAll() {
  QFETCH(QByteArray, text);
  QFETCH(double, number);
  const std::optional<double> read = ui::numberFromText(text.toStdString());
  QCOMPARE(read.has_value(), !std::isnan(number));
  if (read) QCOMPARE(*read, number);
}

QTEST_GUILESS_MAIN(DegreeTextTest)
#include "degree_text_test.moc"
