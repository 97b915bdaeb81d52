#include "ui/view/visible_part.h"

#include <limits>

#include <QTest>

#include "ui/view/camera.h"
#include "ui/view/drawing.h"

class VisiblePartTest : public QObject {
  Q_OBJECT

 private slots:
  void cutsLinesAtTheArea_data();
  void cutsLinesAtTheArea();
  void seesNothingOfNumbersThatAreNone();
  void cutsPolylinesIntoTheirSeenStretches();
  void doesNotRunAlongTheBorderBetweenThem();
  void keepsCoordinatesSmallHoweverFarTheDrawingReaches();
  void seesDiscsThatReachIntoThePicture();
  void drawsArrowsWithTheTipAtTheEnd();

 private:
  static ui::Camera camera() {
    ui::Camera camera;
    camera.setViewport({100, 100});
    camera.fit({1, 1}, {});
    return camera;
  }
};

void VisiblePartTest::cutsLinesAtTheArea_data() {
  QTest::addColumn<QLineF>("line");
  QTest::addColumn<QLineF>("seen");  // null: nothing
  QTest::newRow("inside") << QLineF(1, 1, 9, 9) << QLineF(1, 1, 9, 9);
  QTest::newRow("through") << QLineF(-5, 5, 15, 5) << QLineF(0, 5, 10, 5);
  QTest::newRow("into a corner") << QLineF(5, 5, 15, 15) << QLineF(5, 5, 10, 10);
  QTest::newRow("past") << QLineF(-5, 11, 15, 11) << QLineF();
  QTest::newRow("past a corner") << QLineF(-5, 4, 4, -5) << QLineF();
  QTest::newRow("a point inside") << QLineF(3, 3, 3, 3) << QLineF(3, 3, 3, 3);
  QTest::newRow("a point outside") << QLineF(13, 3, 13, 3) << QLineF();
}

void VisiblePartTest::cutsLinesAtTheArea() {
  QFETCH(QLineF, line);
  QFETCH(QLineF, seen);
  const std::optional<QLineF> part = ui::lineWithin(line, QRectF(0, 0, 10, 10));
  QCOMPARE(part.has_value(), seen != QLineF());
  if (part) QVERIFY(QLineF(part->p1(), seen.p1()).length() < 1e-12);
  if (part) QVERIFY(QLineF(part->p2(), seen.p2()).length() < 1e-12);
}

void VisiblePartTest::seesNothingOfNumbersThatAreNone() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  QVERIFY(!ui::lineWithin(QLineF(nan, 0, 5, 5), QRectF(0, 0, 10, 10)));
  QVERIFY(!ui::seenDisc({{nan, 0.5}, 0.1, 0, 0, 0, 0}, camera()));
}

void VisiblePartTest::cutsPolylinesIntoTheirSeenStretches() {
  // In, out to the right, back in: two stretches, the shares counted along all five points.
  const ui::Polyline polyline{{{0.2, 0.5}, {0.6, 0.5}, {5, 0.5}, {5, 0.6}, {0.5, 0.6}}, 2, 0, true};
  const auto stretches = ui::seenStretches(polyline, camera());
  QCOMPARE(stretches.size(), std::size_t(2));
  QCOMPARE(stretches[0].size(), std::size_t(3));
  QCOMPARE(stretches[0].front().share, 0.0);
  QCOMPARE(stretches[1].back().share, 1.0);
}

void VisiblePartTest::doesNotRunAlongTheBorderBetweenThem() {
  const ui::Polyline polyline{{{0.2, 0.5}, {5, 0.5}, {0.5, 0.9}}, 2, 0, false};
  QCOMPARE(ui::seenStretches(polyline, camera()).size(), std::size_t(2));
}

void VisiblePartTest::keepsCoordinatesSmallHoweverFarTheDrawingReaches() {
  const ui::Polyline polyline{{{-1e9, 0.5}, {1e9, 0.6}}, 2, 0, false};
  for (const auto& stretch : ui::seenStretches(polyline, camera()))
    for (const ui::PolylinePoint& point : stretch) QVERIFY(std::abs(point.place.x()) < 200);
}

void VisiblePartTest::seesDiscsThatReachIntoThePicture() {
  QVERIFY(ui::seenDisc({{-0.1, 0.5}, 0.2, 0, 0, 0, 0}, camera()));
  QVERIFY(!ui::seenDisc({{-0.3, 0.5}, 0.2, 0, 0, 0, 0}, camera()));
}

void VisiblePartTest::drawsArrowsWithTheTipAtTheEnd() {
  const ui::ArrowShape arrow = ui::arrowShape({{0.1, 0.5}, {0.9, 0.5}, 2, 0}, camera());
  QCOMPARE(arrow.head[0], QPointF(90, 50));
  QCOMPARE(arrow.shaft, QLineF(10, 50, 90 - 2 * ui::kArrowHeadLength, 50));
  // Shorter than its head: all head.
  QCOMPARE(ui::arrowShape({{0.5, 0.5}, {0.51, 0.5}, 2, 0}, camera()).shaft.length(), 0.0);
}

QTEST_GUILESS_MAIN(VisiblePartTest)
#include "visible_part_test.moc"
