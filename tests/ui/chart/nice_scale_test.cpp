#include "ui/chart/nice_scale.h"

#include <QTest>

using ui::niceScale;
using ui::NiceScale;

class NiceScaleTest : public QObject {
  Q_OBJECT

 private slots:
  void endsOnShortNumbers_data();
  void endsOnShortNumbers();
  void growsInSteps();
  void neverNeedsMoreIntervalsThanWanted();
};

void NiceScaleTest::endsOnShortNumbers_data() {
  QTest::addColumn<double>("lowest");
  QTest::addColumn<double>("highest");
  QTest::addColumn<int>("intervals");
  QTest::addColumn<NiceScale>("expected");
  QTest::addColumn<int>("decimals");

  QTest::newRow("nothing yet") << 0.0 << 0.0 << 5 << NiceScale{0, 1, 0.2} << 1;
  QTest::newRow("exact end") << 0.0 << 10.0 << 5 << NiceScale{0, 10, 2} << 0;
  QTest::newRow("just over") << 0.0 << 10.01 << 6 << NiceScale{0, 12, 2} << 0;
  QTest::newRow("tenths") << 0.0 << 2.98 << 7 << NiceScale{0, 3, 0.5} << 1;
  QTest::newRow("hundredths") << 0.0 << 0.07 << 4 << NiceScale{0, 0.08, 0.02} << 2;
  QTest::newRow("below zero") << -1.2 << 3.0 << 5 << NiceScale{-2, 3, 1} << 0;
  QTest::newRow("huge") << 0.0 << 2.5e299 << 3 << NiceScale{0, 3e299, 1e299} << 0;
  QTest::newRow("one interval") << 0.0 << 7.0 << 1 << NiceScale{0, 10, 10} << 0;
}

void NiceScaleTest::endsOnShortNumbers() {
  QFETCH(double, lowest);
  QFETCH(double, highest);
  QFETCH(int, intervals);
  QFETCH(NiceScale, expected);

  const NiceScale scale = niceScale(lowest, highest, intervals);

  QCOMPARE(scale.lowest + 1, expected.lowest + 1);  // QCOMPARE's tolerance is none at 0
  QCOMPARE(scale.highest, expected.highest);
  QCOMPARE(scale.step, expected.step);
  QTEST(scale.decimals(), "decimals");
}

void NiceScaleTest::growsInSteps() {
  int changes = 0;
  NiceScale before = niceScale(0, 1, 5);
  for (double highest = 1; highest <= 100; highest += 0.01) {
    const NiceScale scale = niceScale(0, highest, 5);
    QVERIFY(scale.highest >= highest * (1 - 1e-9));
    QVERIFY(scale.highest >= before.highest);
    if (scale != before) ++changes;
    before = scale;
  }
  // Between 1 and 100 with up to 5 intervals: 3 or 4 ends for each of the six step widths.
  QVERIFY2(10 <= changes && changes <= 24, qPrintable(QString::number(changes)));
}

void NiceScaleTest::neverNeedsMoreIntervalsThanWanted() {
  for (int wanted = 1; wanted <= 10; ++wanted) {
    for (double highest = 0.013; highest < 1e4; highest *= 1.07) {
      QVERIFY(niceScale(0, highest, wanted).tickCount() - 1 <= wanted);
    }
  }
}

QTEST_GUILESS_MAIN(NiceScaleTest)
#include "nice_scale_test.moc"
