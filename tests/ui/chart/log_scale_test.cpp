#include "ui/chart/log_scale.h"

#include <cmath>

#include <QLocale>
#include <QTest>

using ui::LogScale;

namespace {

QStringList labelsOf(const LogScale& scale) {
  QStringList labels;
  for (const LogScale::Tick& tick : scale.ticks) labels << tick.label;
  return labels.replaceInStrings(QString(QChar::Nbsp), " ");
}

}  // namespace

class LogScaleTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void writesQuantitiesInTwoDigits_data();
  void writesQuantitiesInTwoDigits();
  void labelsPowersOfTen();
  void leavesOutLabelsThatHaveNoRoom();
  void labelsStepsAsPartsOfASecond();
  void holdsEverythingWithRoomAround();
  void hasTicksForOneValueToo();
};

void LogScaleTest::writesQuantitiesInTwoDigits_data() {
  QTest::addColumn<double>("value");
  QTest::addColumn<QString>("text");
  QTest::newRow("below f") << 1e-16 << "0.1 fm";
  QTest::newRow("p") << 2.34e-12 << "2.3 pm";
  QTest::newRow("n") << 9.96e-10 << "1 nm";
  QTest::newRow("µ") << 1e-6 << "1 µm";
  QTest::newRow("m") << 0.1 << "100 mm";
  QTest::newRow("one") << 1.0 << "1 m";
  QTest::newRow("none") << 12345.0 << "12000 m";
}

void LogScaleTest::writesQuantitiesInTwoDigits() {
  QFETCH(double, value);
  QFETCH(QString, text);
  QCOMPARE(ui::prefixedText(value, "m").replace(QChar(QChar::Nbsp), ' '), text);
}

void LogScaleTest::labelsPowersOfTen() {
  const LogScale scale = ui::decadeScale(2e-6, 0.02, "s", 10);
  QCOMPARE(labelsOf(scale), QStringList({"10 µs", "100 µs", "1 ms", "10 ms"}));
  QCOMPARE(scale.ticks.front().place, -5.0);
}

void LogScaleTest::leavesOutLabelsThatHaveNoRoom() {
  const LogScale scale = ui::decadeScale(1e-12, 1, "m", 6);
  QCOMPARE(labelsOf(scale), QStringList({"1 pm", "1 nm", "1 µm", "1 mm", "1 m"}));
  QCOMPARE(labelsOf(ui::decadeScale(1e-12, 1, "m", 3)), QStringList({"1 pm", "1 µm", "1 m"}));
}

void LogScaleTest::labelsStepsAsPartsOfASecond() {
  const LogScale scale = ui::stepScale(1.0 / 8192, 2, 20);
  QCOMPARE(scale.ticks.size(), std::size_t{15});
  QCOMPARE(scale.ticks.front().label, QString("1/8192 s"));
  QCOMPARE(scale.ticks.back().label, QString("2 s"));
  QVERIFY(std::abs(scale.ticks.front().place - std::log10(1.0 / 8192)) < 1e-12);
  QVERIFY(ui::stepScale(1.0 / 8192, 2, 5).ticks.size() <= 5);
}

void LogScaleTest::holdsEverythingWithRoomAround() {
  const LogScale scale = ui::decadeScale(1e-12, 1, "m", 20);
  QVERIFY(-12.6 < scale.lowest && scale.lowest < -12.1);
  QVERIFY(0.1 < scale.highest && scale.highest < 0.6);
}

void LogScaleTest::hasTicksForOneValueToo() {
  for (const double value : {1e-3, 2e-3, 9e-3}) {
    QVERIFY(!ui::decadeScale(value, value, "m", 5).ticks.empty());
    QVERIFY(ui::stepScale(value, value, 5).ticks.size() >= 2);
  }
}

QTEST_APPLESS_MAIN(LogScaleTest)
#include "log_scale_test.moc"
