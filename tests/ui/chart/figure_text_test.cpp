#include "ui/chart/figure_text.h"

#include <limits>

#include <QLocale>
#include <QTest>

class FigureTextTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }
  void readsAsAPersonWouldWriteIt_data();
  void readsAsAPersonWouldWriteIt();
  void followsTheLocale();
  void keepsAxisNumbersShort_data();
  void keepsAxisNumbersShort();
};

void FigureTextTest::readsAsAPersonWouldWriteIt_data() {
  QTest::addColumn<double>("value");
  QTest::addColumn<QString>("expected");

  QTest::newRow("zero") << 0.0 << "0";
  QTest::newRow("one") << 1.0 << "+1.00";
  QTest::newRow("negative") << -12.44 << "−12.4";
  QTest::newRow("hundreds") << 123.4 << "+123";
  QTest::newRow("thousands") << 45678.0 << "+45,678";
  QTest::newRow("small") << 0.03123 << "+0.0312";
  QTest::newRow("smallest plain") << 0.001234 << "+0.00123";
  QTest::newRow("tiny") << -3.14e-9 << "−3.1·10⁻⁹";
  QTest::newRow("mantissa rounds to ten") << 9.96e-10 << "+1.0·10⁻⁹";
  QTest::newRow("large") << 2.4e300 << "+2.4·10³⁰⁰";
  QTest::newRow("smallest double") << 4.94e-324 << "+4.9·10⁻³²⁴";
  QTest::newRow("infinite") << -std::numeric_limits<double>::infinity() << "−∞";
}

void FigureTextTest::readsAsAPersonWouldWriteIt() {
  QFETCH(double, value);
  QTEST(ui::signedFigure(value), "expected");
}

void FigureTextTest::followsTheLocale() {
  QLocale::setDefault(QLocale(QLocale::German));
  const QString text = ui::signedFigure(-0.5);
  QLocale::setDefault(QLocale(QLocale::English));
  QCOMPARE(text, QStringLiteral("−0,500"));
}

void FigureTextTest::keepsAxisNumbersShort_data() {
  QTest::addColumn<double>("highest");
  QTest::addColumn<QString>("symbol");
  QTest::addColumn<double>("size");

  QTest::newRow("nothing") << 0.0 << "J" << 1.0;
  QTest::newRow("as it is") << 2.9 << "J" << 1.0;
  QTest::newRow("thousands still plain") << 9999.0 << "J" << 1.0;
  QTest::newRow("kilo") << 1e4 << "kJ" << 1e3;
  QTest::newRow("mega") << 1e6 << "MJ" << 1e6;
  QTest::newRow("milli") << 0.099 << "mJ" << 1e-3;
  QTest::newRow("nano") << 2e-8 << "nJ" << 1e-9;
  QTest::newRow("beyond the last prefix") << 1e30 << "EJ" << 1e18;
  QTest::newRow("below the first prefix") << 1e-20 << "nJ" << 1e-9;
}

void FigureTextTest::keepsAxisNumbersShort() {
  QFETCH(double, highest);
  QFETCH(double, size);
  const ui::ScaledUnit unit = ui::scaledUnit(highest, "J");
  QTEST(unit.symbol, "symbol");
  QCOMPARE(unit.size, size);
}

QTEST_GUILESS_MAIN(FigureTextTest)
#include "figure_text_test.moc"
