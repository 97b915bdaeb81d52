#include "ui/chart/chart_zoom.h"

#include <QTest>

class ChartZoomTest : public QObject {
  Q_OBJECT

 private slots:
  void keepsThePointThatItZoomsAbout();
  void movesByAShareOfWhatIsShown();
  void goesNoFurtherThanNumbersDo_data();
  void goesNoFurtherThanNumbersDo();
};

void ChartZoomTest::keepsThePointThatItZoomsAbout() {
  const QRectF range(0, -2, 10, 8);
  QCOMPARE(ui::zoomedAbout(range, QPointF(5, 2), 2, 4), QRectF(2.5, 1, 5, 2));
  QCOMPARE(ui::zoomedAbout(range, QPointF(0, -2), 2, 1), QRectF(0, -2, 5, 8));
  const QRectF there = ui::zoomedAbout(range, QPointF(7, 3), 3, 3);
  const QRectF back = ui::zoomedAbout(there, QPointF(7, 3), 1.0 / 3, 1.0 / 3);
  QVERIFY(std::abs(back.left() - range.left()) < 1e-12);
  QVERIFY(std::abs(back.height() - range.height()) < 1e-12);
}

void ChartZoomTest::movesByAShareOfWhatIsShown() {
  QCOMPARE(ui::movedBy(QRectF(0, 0, 10, 4), 0.1, -0.5), QRectF(1, -2, 10, 4));
}

void ChartZoomTest::goesNoFurtherThanNumbersDo_data() {
  QTest::addColumn<QRectF>("range");
  QTest::addColumn<bool>("shown");
  QTest::newRow("usual") << QRectF(0, 0, 10, 3) << true;
  QTest::newRow("a millionth") << QRectF(5, 5, 1e-6, 1e-6) << true;
  QTest::newRow("too fine for its values") << QRectF(5, 5, 1e-9, 1) << false;
  QTest::newRow("too fine") << QRectF(0, 0, 1, 1e-13) << false;
  QTest::newRow("too far") << QRectF(0, 0, 1e13, 1) << false;
}

void ChartZoomTest::goesNoFurtherThanNumbersDo() {
  QFETCH(QRectF, range);
  QTEST(ui::canBeShown(range), "shown");
}

QTEST_GUILESS_MAIN(ChartZoomTest)
#include "chart_zoom_test.moc"
