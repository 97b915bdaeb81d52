#include "core/trade/work_precision.h"

#include <cmath>

#include <QtTest>

using core::Measurement;
using core::MethodCurve;
using core::Reach;

namespace {

/// A method of order 4 whose error is step⁴ [m] and whose cost is 1000/step [ns per second], at
/// steps 1/2, 1/4, …
MethodCurve orderFour(int count) {
  MethodCurve curve{core::findMethod("rk4"), {}};
  for (int i = 1; i <= count; ++i) {
    const double step = std::ldexp(1, -i);
    core::MeasuredPoint point;
    point.solver = core::solverWith(*curve.method, step);
    point.maxPositionError = std::pow(step, 4);
    point.nanosecondsPerSimulatedSecond = 1000 / step;
    curve.points.push_back(point);
  }
  return curve;
}

void compare(double actual, double expected) {
  QVERIFY2(std::abs(actual / expected - 1) < 1e-9, qPrintable(QString::number(actual, 'g', 12)));
}

}  // namespace

class WorkPrecisionTest : public QObject {
  Q_OBJECT

 private slots:
  void interpolatesBetweenPoints();
  void extrapolatesAlongTheLaw();
  void saysWhenTheCoarsestSettingDoes();
  void findsNothingWhereTheErrorFollowsNoLaw();
  void findsNothingBelowTheUncertainty();
  void doesNotTrustALuckyPoint();
  void isNotMisledByRounding();
  void whatIsExactNeedsNoFinerStep();
  void leavesOutWhatDiverged();
};

void WorkPrecisionTest::interpolatesBetweenPoints() {
  const auto reached = core::reach({}, orderFour(6), std::pow(0.1, 4));
  QVERIFY(reached);
  QCOMPARE(reached->source, Reach::Source::kInterpolated);
  compare(reached->setting, 0.1);
  compare(reached->nanosecondsPerSimulatedSecond, 10000);
}

void WorkPrecisionTest::extrapolatesAlongTheLaw() {
  const auto reached = core::reach({}, orderFour(6), std::pow(0.001, 4));
  QVERIFY(reached);
  QCOMPARE(reached->source, Reach::Source::kExtrapolated);
  compare(reached->setting, 0.001);
  compare(reached->nanosecondsPerSimulatedSecond, 1e6);
}

void WorkPrecisionTest::saysWhenTheCoarsestSettingDoes() {
  const auto reached = core::reach({}, orderFour(6), 0.5);
  QVERIFY(reached);
  QCOMPARE(reached->source, Reach::Source::kCoarsest);
  QCOMPARE(reached->setting, 0.5);
  QCOMPARE(reached->nanosecondsPerSimulatedSecond, 2000.0);
}

void WorkPrecisionTest::findsNothingWhereTheErrorFollowsNoLaw() {
  MethodCurve curve = orderFour(6);
  for (core::MeasuredPoint& point : curve.points) point.maxPositionError = 3;
  QVERIFY(!core::reach({}, curve, 1e-3));
}

void WorkPrecisionTest::findsNothingBelowTheUncertainty() {
  Measurement measurement;
  measurement.uncertainty = 1e-6;
  QVERIFY(core::reach(measurement, orderFour(6), 2e-6));
  QVERIFY(!core::reach(measurement, orderFour(6), 5e-7));
}

void WorkPrecisionTest::doesNotTrustALuckyPoint() {
  MethodCurve curve = orderFour(6);
  curve.points[0].maxPositionError = 1e-5;
  const auto reached = core::reach({}, curve, std::pow(0.1, 4));
  QVERIFY(reached);
  compare(reached->setting, 0.1);
}

void WorkPrecisionTest::isNotMisledByRounding() {
  MethodCurve curve = orderFour(6);
  curve.points[5].maxPositionError = 1;
  const auto reached = core::reach({}, curve, std::pow(0.1, 4));
  QVERIFY(reached);
  QCOMPARE(reached->source, Reach::Source::kInterpolated);
  compare(reached->setting, 0.1);
}

void WorkPrecisionTest::whatIsExactNeedsNoFinerStep() {
  MethodCurve curve = orderFour(3);
  curve.points[2].maxPositionError = 0;
  QCOMPARE(core::reach({}, curve, 1e-9)->setting, 0.125);
  QCOMPARE(core::chartedPoints(curve).size(), std::size_t{2});
  for (core::MeasuredPoint& point : curve.points) point.maxPositionError = 0;
  QCOMPARE(core::reach({}, curve, 1e-9)->source, Reach::Source::kCoarsest);
}

void WorkPrecisionTest::leavesOutWhatDiverged() {
  MethodCurve curve = orderFour(6);
  curve.points[0].status = core::RunStatus::kDiverged;
  QCOMPARE(core::chartedPoints(curve).size(), std::size_t{5});
  QCOMPARE(core::reach({}, curve, 0.5)->setting, 0.25);
}

QTEST_APPLESS_MAIN(WorkPrecisionTest)
#include "work_precision_test.moc"
