#include "ui/control/quantity_text.h"

#include <numbers>

#include <QLocale>
#include <QTest>

class QuantityTextTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QLocale::setDefault(QLocale::c()); }
  void readsWhatPeopleType_data();
  void readsWhatPeopleType();
  void refusesWhatIsNoNumber_data();
  void refusesWhatIsNoNumber();
  void writesConvertedAnglesWithoutNoise();
  void writesInTheReadersFormat();
  void writesPartsAsFractions_data();
  void writesPartsAsFractions();
  void namesRangesWithTheirUnit();
};

void QuantityTextTest::readsWhatPeopleType_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("unit");
  QTest::addColumn<double>("value");
  QTest::newRow("plain") << "9.81"
                         << "m/s²" << 9.81;
  QTest::newRow("comma") << "9,81"
                         << "m/s²" << 9.81;
  QTest::newRow("with unit") << "9.81 m/s²"
                             << "m/s²" << 9.81;
  QTest::newRow("degrees") << "-70°"
                           << "°" << -70.0;
  QTest::newRow("typographic minus") << "\u221270"
                                     << "°" << -70.0;
  QTest::newRow("exponent") << " 1e-3 "
                            << "s" << 0.001;
  QTest::newRow("fraction") << "1/240"
                            << "s" << 1.0 / 240;
  QTest::newRow("fraction with unit") << "1 / 240 s"
                                      << "s" << 1.0 / 240;
}

void QuantityTextTest::readsWhatPeopleType() {
  QFETCH(QString, text);
  QFETCH(QString, unit);
  QFETCH(double, value);
  const std::optional<double> read = ui::parsedQuantity(text, unit);
  QVERIFY(read.has_value());
  QCOMPARE(*read, value);
}

void QuantityTextTest::refusesWhatIsNoNumber_data() {
  QTest::addColumn<QString>("text");
  for (const char* text :
       {"", "abc", "nan", "inf", "1e999", "1/0", "1/2/3", "5 kg", "1 2", "1,2.3"}) {
    QTest::newRow(*text == '\0' ? "empty" : text) << text;
  }
}

void QuantityTextTest::refusesWhatIsNoNumber() {
  QFETCH(QString, text);
  QVERIFY(!ui::parsedQuantity(text, "m").has_value());
}

void QuantityTextTest::writesConvertedAnglesWithoutNoise() {
  const double seventy = 70 * std::numbers::pi / 180;
  QCOMPARE(ui::quantityText(seventy * 180 / std::numbers::pi), QString("70"));
}

void QuantityTextTest::writesInTheReadersFormat() {
  QLocale::setDefault(QLocale(QLocale::Swedish));
  QCOMPARE(ui::quantityText(9.81), QString("9,81"));
}

void QuantityTextTest::writesPartsAsFractions_data() {
  QTest::addColumn<double>("value");
  QTest::addColumn<QString>("text");
  QTest::newRow("1/60") << 1.0 / 60 << "1/60";
  QTest::newRow("1/4096") << 1.0 / 4096 << "1/4096";
  QTest::newRow("no part") << 0.0166667 << "0.0166667";
  QTest::newRow("whole") << 2.0 << "2";
}

void QuantityTextTest::writesPartsAsFractions() {
  QFETCH(double, value);
  QTEST(ui::fractionText(value), "text");
}

void QuantityTextTest::namesRangesWithTheirUnit() {
  QCOMPARE(ui::rangeText(core::kGravityRange), QString("from 0 to 1000\u00a0m/s²"));
  QCOMPARE(ui::rangeText(core::kRopeAngleRange), QString("from -180 to 180°"));
  QCOMPARE(ui::rangeText(core::kCutTimeRange), QString("0\u00a0s or more"));
}

QTEST_MAIN(QuantityTextTest)
#include "quantity_text_test.moc"
