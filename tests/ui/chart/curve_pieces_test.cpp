#include "ui/chart/curve_pieces.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <QTest>

using core::TimedPoint;

namespace {

using Curve = std::vector<TimedPoint>;
using Pieces = std::vector<QPolygonF>;

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
const QRectF kRange(0, 0, 10, 10);

/// A point of a curve over time.
TimedPoint at(double time, double y) {
  return {time, time, y};
}

/// Twice the area, whatever the direction.
double areaOf(const QPolygonF& polygon) {
  double sum = 0;
  for (qsizetype i = 0; i < polygon.size(); ++i) {
    const QPointF a = polygon[i];
    const QPointF b = polygon[(i + 1) % polygon.size()];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return std::abs(sum) / 2;
}

}  // namespace

Q_DECLARE_METATYPE(Curve)
Q_DECLARE_METATYPE(Pieces)

class CurvePiecesTest : public QObject {
  Q_OBJECT

 private slots:
  void keepsWhatLiesInTheRange_data();
  void keepsWhatLiesInTheRange();
  void keepsEveryPeakWithFewPoints();
  void cutsAreas_data();
  void cutsAreas();
  void findsThePartBetweenTwoMoments();
  void boundsTheWorkForAnyNumberOfCurves();
};

void CurvePiecesTest::keepsWhatLiesInTheRange_data() {
  QTest::addColumn<Curve>("curve");
  QTest::addColumn<Pieces>("expected");

  QTest::newRow("empty") << Curve{} << Pieces{};
  QTest::newRow("one point") << Curve{at(0, 3)} << Pieces{QPolygonF({{0, 3}})};
  QTest::newRow("inside") << Curve{at(0, 0), at(1, 10), at(2, 5)}
                          << Pieces{QPolygonF({{0, 0}, {1, 10}, {2, 5}})};
  QTest::newRow("leaves for good")
      << Curve{at(0, 5), at(1, 15), at(2, 20)} << Pieces{QPolygonF({{0, 5}, {0.5, 10}})};
  QTest::newRow("comes in") << Curve{at(0, 30), at(1, 20), at(2, 0)}
                            << Pieces{QPolygonF({{1.5, 10}, {2, 0}})};
  QTest::newRow("is away for a while")
      << Curve{at(0, 5), at(1, 15), at(2, 15), at(3, 5)}
      << Pieces{QPolygonF({{0, 5}, {0.5, 10}}), QPolygonF({{2.5, 10}, {3, 5}})};
  QTest::newRow("passes in one step")
      << Curve{at(4, 15), at(6, -5)} << Pieces{QPolygonF({{4.5, 10}, {5.5, 0}})};
  QTest::newRow("only outside") << Curve{at(0, 20), at(1, 30)} << Pieces{};
  QTest::newRow("turns back") << Curve{{0, 5, 5}, {1, 15, 5}, {2, 5, 6}}
                              << Pieces{QPolygonF({{5, 5}, {10, 5}}),
                                        QPolygonF({{10, 5.5}, {5, 6}})};
  QTest::newRow("has a gap") << Curve{at(0, 1), at(1, 2), {2, kGap, kGap}, at(3, 4), at(4, 5)}
                             << Pieces{QPolygonF({{0, 1}, {1, 2}}), QPolygonF({{3, 4}, {4, 5}})};
}

void CurvePiecesTest::keepsWhatLiesInTheRange() {
  QFETCH(Curve, curve);
  QFETCH(Pieces, expected);
  const Pieces pieces = ui::piecesInside(curve, kRange, 100);
  QCOMPARE(pieces.size(), expected.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    QCOMPARE(pieces[i].size(), expected[i].size());
    for (qsizetype k = 0; k < pieces[i].size(); ++k) {
      QVERIFY(QLineF(pieces[i][k], expected[i][k]).length() < 1e-12);
    }
  }
}

void CurvePiecesTest::keepsEveryPeakWithFewPoints() {
  Curve curve;
  for (int i = 0; i < 10000; ++i) curve.push_back(at(i * 1e-3, i == 4711 ? 9 : 1));
  const Pieces pieces = ui::piecesInside(curve, kRange, 200);
  QCOMPARE(pieces.size(), std::size_t{1});
  QVERIFY(pieces[0].size() <= 200);
  QVERIFY(pieces[0].contains(QPointF(4.711, 9)));
}

void CurvePiecesTest::cutsAreas_data() {
  QTest::addColumn<Curve>("curve");
  QTest::addColumn<double>("base");
  QTest::addColumn<double>("area");

  QTest::newRow("above its base") << Curve{at(0, 2), at(4, 2)} << 0.0 << 8.0;
  QTest::newRow("below its base") << Curve{at(0, 2), at(4, 2)} << 5.0 << 12.0;
  QTest::newRow("beyond the top") << Curve{at(0, 20), at(4, 20)} << 0.0 << 40.0;
  QTest::newRow("beyond the side") << Curve{at(8, 1), at(14, 1)} << 0.0 << 2.0;
  // A triangle with its tip cut off: 16 of a base of 8 and half as much height, less the tip.
  QTest::newRow("through the top") << Curve{at(1, 8), at(5, 12), at(9, 8)} << 8.0 << 12.0;
  QTest::newRow("far beyond") << Curve{at(0, 1e300), at(4, 1e300)} << 0.0 << 40.0;
}

void CurvePiecesTest::cutsAreas() {
  QFETCH(Curve, curve);
  QFETCH(double, base);
  QFETCH(double, area);
  const Pieces areas = ui::areasInside(curve, base, kRange, 100);
  QCOMPARE(areas.size(), std::size_t{1});
  QVERIFY(std::abs(areaOf(areas[0]) - area) < 1e-6);
  QVERIFY(kRange.adjusted(-1e-6, -1e-6, 1e-6, 1e-6).contains(areas[0].boundingRect()));
}

void CurvePiecesTest::findsThePartBetweenTwoMoments() {
  Curve curve;
  for (int i = 0; i < 10; ++i) curve.push_back(at(i, i));
  const auto part = ui::partBetween(curve, 3.5, 5.5);
  QCOMPARE(part.front().time, 3.0);
  QCOMPARE(part.back().time, 6.0);
  QCOMPARE(ui::partBetween(curve, -1, 100).size(), curve.size());
  QVERIFY(ui::partBetween({}, 0, 1).empty());
}

void CurvePiecesTest::boundsTheWorkForAnyNumberOfCurves() {
  QCOMPARE(ui::mostPointsPerCurve(0, 10000), std::size_t{2000});
  QCOMPARE(ui::mostPointsPerCurve(1, 10000), std::size_t{2000});
  QCOMPARE(ui::mostPointsPerCurve(5, 10000), std::size_t{2000});
  QCOMPARE(ui::mostPointsPerCurve(10, 10000), std::size_t{1000});
  QCOMPARE(ui::mostPointsPerCurve(28, 10000), std::size_t{357});
}

QTEST_GUILESS_MAIN(CurvePiecesTest)
#include "curve_pieces_test.moc"
