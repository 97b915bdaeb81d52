#include "ui/view/ruler.h"

#include <QLocale>
#include <QTest>

class RulerTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void spacesByOneTwoOrFive_data();
  void spacesByOneTwoOrFive();
  void writesLengthsInTheUnitThatSuits_data();
  void writesLengthsInTheUnitThatSuits();
  void usesTheReadersDecimalPoint();
};

void RulerTest::spacesByOneTwoOrFive_data() {
  QTest::addColumn<double>("least");
  QTest::addColumn<double>("spacing");
  QTest::newRow("exact") << 0.5 << 0.5;
  QTest::newRow("a little more") << 0.51 << 1.0;
  QTest::newRow("a little less") << 0.19 << 0.2;
  QTest::newRow("exact power") << 0.001 << 0.001;
  QTest::newRow("large") << 12345.0 << 20000.0;
  QTest::newRow("small") << 3.3e-6 << 5e-6;
}

void RulerTest::spacesByOneTwoOrFive() {
  QFETCH(double, least);
  QFETCH(double, spacing);
  QCOMPARE(ui::rulerFor(least, 4).spacing, spacing);
}

void RulerTest::writesLengthsInTheUnitThatSuits_data() {
  QTest::addColumn<double>("least");
  QTest::addColumn<double>("extent");
  QTest::addColumn<double>("length");
  QTest::addColumn<QString>("text");
  QTest::newRow("classroom") << 0.4 << 4.0 << 1.5 << "1.5 m";
  QTest::newRow("whole numbers") << 1.0 << 4.0 << 3.0 << "3 m";
  QTest::newRow("same decimals") << 0.4 << 4.0 << 2.0 << "2.0 m";
  QTest::newRow("zero") << 0.4 << 4.0 << -1e-17 << "0 m";
  QTest::newRow("thimble") << 0.002 << 0.01 << 0.006 << "6 mm";
  QTest::newRow("box") << 0.05 << 0.5 << 0.25 << "25 cm";
  QTest::newRow("valley") << 1e4 << 1e5 << 3e4 << "30 km";
  QTest::newRow("close-up far out") << 0.1 << 1e5 << 43210.1 << "43.2101 km";
}

void RulerTest::writesLengthsInTheUnitThatSuits() {
  QFETCH(double, least);
  QFETCH(double, extent);
  QFETCH(double, length);
  QFETCH(QString, text);
  // The space before a unit does not break lines.
  QCOMPARE(ui::rulerFor(least, extent).textAt(length).replace(QChar(0xa0), ' '), text);
}

void RulerTest::usesTheReadersDecimalPoint() {
  QLocale::setDefault(QLocale(QLocale::German));
  QVERIFY(ui::rulerFor(0.5, 4).textAt(1.5).startsWith("1,5"));
  QLocale::setDefault(QLocale::c());
}

QTEST_GUILESS_MAIN(RulerTest)
#include "ruler_test.moc"
