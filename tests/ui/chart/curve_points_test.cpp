#include "ui/chart/curve_points.h"

#include <QTest>

using core::CurvePoint;

class CurvePointsTest : public QObject {
  Q_OBJECT

 private slots:
  void keepsWhatLiesBetweenTheLimits_data();
  void keepsWhatLiesBetweenTheLimits();
  void boundsTheWorkForAnyNumberOfCurves();
};

void CurvePointsTest::keepsWhatLiesBetweenTheLimits_data() {
  using Curve = std::vector<CurvePoint>;
  using Cut = QList<QPointF>;
  QTest::addColumn<Curve>("curve");
  QTest::addColumn<Cut>("expected");

  QTest::newRow("empty") << Curve{} << Cut{};
  QTest::newRow("inside") << Curve{{0, 0}, {1, 10}, {2, 5}} << Cut{{0, 0}, {1, 10}, {2, 5}};
  QTest::newRow("leaves for good") << Curve{{0, 5}, {1, 15}, {2, 1e300}} << Cut{{0, 5}, {0.5, 10}};
  QTest::newRow("comes in") << Curve{{0, 30}, {1, 20}, {2, 0}} << Cut{{1.5, 10}, {2, 0}};
  QTest::newRow("is away for a while")
      << Curve{{0, 5}, {1, 15}, {2, 15}, {3, 5}} << Cut{{0, 5}, {0.5, 10}, {2.5, 10}, {3, 5}};
  QTest::newRow("from above to below")
      << Curve{{0, 5}, {1, 20}, {2, -10}, {3, 5}}
      << Cut{{0, 5}, {1.0 / 3, 10}, {4.0 / 3, 10}, {5.0 / 3, 0}, {2 + 2.0 / 3, 0}, {3, 5}};
  QTest::newRow("only outside") << Curve{{0, 20}, {1, 30}} << Cut{};
  QTest::newRow("opposite ends of all doubles")
      << Curve{{0, 5}, {1, 1.7e308}, {2, -1.7e308}, {3, 5}}
      << Cut{{0, 5}, {0, 10}, {1.5, 10}, {1.5, 0}, {3, 0}, {3, 5}};
}

void CurvePointsTest::keepsWhatLiesBetweenTheLimits() {
  QFETCH(std::vector<CurvePoint>, curve);
  QTEST(ui::cutToScale(curve, 0, 10), "expected");
}

void CurvePointsTest::boundsTheWorkForAnyNumberOfCurves() {
  QCOMPARE(ui::mostPointsPerCurve(0, 10000), std::size_t{2000});
  QCOMPARE(ui::mostPointsPerCurve(1, 10000), std::size_t{2000});
  QCOMPARE(ui::mostPointsPerCurve(5, 10000), std::size_t{2000});
  QCOMPARE(ui::mostPointsPerCurve(10, 10000), std::size_t{1000});
  QCOMPARE(ui::mostPointsPerCurve(28, 10000), std::size_t{357});
}

QTEST_GUILESS_MAIN(CurvePointsTest)
#include "curve_points_test.moc"
