#include "ui/chart/run_pen.h"

#include <QTest>

class RunPenTest : public QObject {
  Q_OBJECT

 private slots:
  void drawsTheFirstRunSolidAndEachOtherInItsOwnPattern();
  void givesUpDashesOnlyWhereTheyAreTooMany();
};

void RunPenTest::drawsTheFirstRunSolidAndEachOtherInItsOwnPattern() {
  QCOMPARE(ui::runPen(Qt::red, 2, 0).style(), Qt::SolidLine);
  for (std::size_t run = 1; run < 4; ++run) {
    QCOMPARE(ui::runPen(Qt::red, 2, run).style(), Qt::CustomDashLine);
    for (std::size_t other = 1; other < run; ++other) {
      QVERIFY(ui::runPen(Qt::red, 2, run).dashPattern() !=
              ui::runPen(Qt::red, 2, other).dashPattern());
    }
  }
}

void RunPenTest::givesUpDashesOnlyWhereTheyAreTooMany() {
  const QSizeF unit(100, 50);  // [px]
  QList<QPointF> curve;
  for (int i = 0; i <= 10; ++i) curve.append(QPointF(i / 10.0, 2 * (i % 2)));
  QVERIFY(!ui::isTooDenseForDashes(curve, unit));  // ten times 100 px
  for (int i = 0; i <= 90; ++i) curve.append(QPointF(1 + i / 90.0, 2 * (i % 2)));
  QVERIFY(ui::isTooDenseForDashes(curve, unit));  // a hundred times
  QVERIFY(!ui::isTooDenseForDashes(curve, unit / 10));
  QVERIFY(!ui::isTooDenseForSmoothLines(curve, unit));
  QVERIFY(ui::isTooDenseForSmoothLines(curve, 4 * unit));
}

QTEST_GUILESS_MAIN(RunPenTest)
#include "run_pen_test.moc"
