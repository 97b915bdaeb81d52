#include "ui/view/hanging_rope.h"

#include <QTest>

using Eigen::Vector2d;

class HangingRopeTest : public QObject {
  Q_OBJECT

 private slots:
  void isAsLongAsTheRope_data();
  void isAsLongAsTheRope();
  void sagsBelowBothEnds();
  void isStraightWhenTaut();
};

void HangingRopeTest::isAsLongAsTheRope_data() {
  QTest::addColumn<double>("x");
  QTest::addColumn<double>("y");
  QTest::newRow("beside") << 0.6 << 0.0;
  QTest::newRow("lower") << 0.3 << -0.7;
  QTest::newRow("higher") << -0.4 << 0.5;
  QTest::newRow("nearly taut") << 0.6 << -0.799;
  QTest::newRow("straight above") << 0.0 << 0.5;
  QTest::newRow("at the pivot") << 0.0 << 0.0;
}

void HangingRopeTest::isAsLongAsTheRope() {
  QFETCH(double, x);
  QFETCH(double, y);
  const Vector2d from(2, 3);
  const Vector2d to = from + Vector2d(x, y);
  const std::vector<Vector2d> points = ui::hangingRope(from, to, 1, 200);
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  QVERIFY((points.front() - from).norm() < 1e-9);
  QVERIFY2((points.back() - to).norm() < 1e-9, qPrintable(QString::number(points.back().x())));
  // Chords cut the bend at the bottom short, most where a rope is folded; a percent is not seen.
  QVERIFY2(std::abs(length - 1) < 0.01, qPrintable(QString::number(length)));
}

void HangingRopeTest::sagsBelowBothEnds() {
  double lowest = 0;
  for (const Vector2d& point : ui::hangingRope({0, 0}, {0.6, 0}, 1))
    lowest = std::min(lowest, point.y());
  // A rope of 1 m between ends 0.6 m apart: from the catenary's equations, solved separately.
  QVERIFY2(std::abs(lowest + 0.3628) < 2e-3, qPrintable(QString::number(lowest)));
}

void HangingRopeTest::isStraightWhenTaut() {
  QCOMPARE(ui::hangingRope({0, 0}, {0.6, -0.8}, 1).size(), std::size_t(2));
  QCOMPARE(ui::hangingRope({0, 0}, {3, 0}, 1).size(), std::size_t(2));
}

QTEST_GUILESS_MAIN(HangingRopeTest)
#include "hanging_rope_test.moc"
