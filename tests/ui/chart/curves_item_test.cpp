#include "ui/chart/curves_item.h"

#include <algorithm>
#include <cmath>

#include <QTest>

class CurvesItemTest : public QObject {
  Q_OBJECT

 private slots:
  void mapsTheRangeToThePlotWithTheLowestValueBelow();
  void hatchesASquareFromEdgeToEdge_data();
  void hatchesASquareFromEdgeToEdge();
  void hatchesBothArmsOfAHollowShape();
  void leavesOutOnlyWhatIsNotSeen();
  void keepsWhereALineTurnsBack();
};

void CurvesItemTest::mapsTheRangeToThePlotWithTheLowestValueBelow() {
  const QTransform toPlot = ui::plotTransform(QRectF(2, -1, 4, 3), QRectF(100, 50, 200, 90));
  QCOMPARE(toPlot.map(QPointF(2, -1)), QPointF(100, 140));
  QCOMPARE(toPlot.map(QPointF(6, 2)), QPointF(300, 50));
  QCOMPARE(toPlot.map(QPointF(3, 0)), QPointF(150, 110));
}

void CurvesItemTest::hatchesASquareFromEdgeToEdge_data() {
  QTest::addColumn<int>("direction");
  QTest::newRow("rising on paper") << 1;
  QTest::newRow("falling on paper") << -1;
}

void CurvesItemTest::hatchesASquareFromEdgeToEdge() {
  QFETCH(int, direction);
  const QPolygonF square({QPointF(0, 0), QPointF(30, 0), QPointF(30, 30), QPointF(0, 30)});
  const std::vector<QLineF> lines = ui::hatchLines(square, 10, direction);
  QCOMPARE(lines.size(), std::size_t{6});  // 60 wide, 10 apart, half-open
  double longest = 0;
  for (const QLineF& line : lines) {
    // On paper y grows downwards: direction 1 rises to the right.
    QVERIFY(std::abs((line.p2().y() - line.p1().y()) +
                     direction * (line.p2().x() - line.p1().x())) < 1e-9);
    longest = std::max(longest, line.length());
  }
  QVERIFY(std::abs(longest - 30 * std::sqrt(2)) < 1e-9);
}

void CurvesItemTest::hatchesBothArmsOfAHollowShape() {
  const QPolygonF u({QPointF(0, 0), QPointF(10, 0), QPointF(10, 40), QPointF(50, 40),
                     QPointF(50, 0), QPointF(60, 0), QPointF(60, 50), QPointF(0, 50)});
  for (const QLineF& line : ui::hatchLines(u, 7, 1)) {
    const QPointF middle = line.center();
    QVERIFY2(u.containsPoint(middle, Qt::OddEvenFill) || line.length() < 1e-9,
             qPrintable(QString("%1, %2").arg(middle.x()).arg(middle.y())));
  }
}

void CurvesItemTest::leavesOutOnlyWhatIsNotSeen() {
  QPolygonF wave;
  for (int i = 0; i <= 2000; ++i) wave.append(QPointF(i / 2.0, 50 * std::sin(i / 100.0)));
  const QPolygonF fewer = ui::simplified(wave, 0.2);
  QVERIFY(fewer.size() < 200);
  QVERIFY(fewer.size() > 20);
  for (const QPointF& point : wave) {
    const auto after = std::ranges::lower_bound(fewer, point.x(), {}, &QPointF::x);
    const QPointF to = *after;
    const QPointF from = after == fewer.begin() ? to : *(after - 1);
    const double part = to.x() > from.x() ? (point.x() - from.x()) / (to.x() - from.x()) : 0;
    QVERIFY(std::abs(from.y() + part * (to.y() - from.y()) - point.y()) < 0.3);
  }
  QCOMPARE(ui::simplified(QPolygonF({{0, 1}, {1, 1}, {2, 1}, {9, 1}}), 0.2),
           QPolygonF({{0, 1}, {9, 1}}));
}

void CurvesItemTest::keepsWhereALineTurnsBack() {
  // From 10 to 5 and on to 20 nothing is drawn that is not drawn anyway.
  const QPolygonF back({{0, 0}, {10, 0}, {5, 0}, {20, 0}, {-3, 0}, {4, 0}});
  QCOMPARE(ui::simplified(back, 0.2), QPolygonF({{0, 0}, {20, 0}, {-3, 0}, {4, 0}}));
}

QTEST_GUILESS_MAIN(CurvesItemTest)
#include "curves_item_test.moc"
