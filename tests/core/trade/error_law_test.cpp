#include "core/trade/error_law.h"

#include <cmath>
#include <vector>

#include <QtTest>

using core::CurvePoint;
using core::ErrorLaw;
using core::errorLaw;

namespace {

/// Errors at steps 1/8, 1/16, … of which each is `error(step)`.
template <class Error>
std::vector<CurvePoint> curveOf(const Error& error, int count = 11) {
  std::vector<CurvePoint> curve;
  for (int i = 0; i < count; ++i) {
    const double step = std::ldexp(1, -3 - i);
    curve.push_back({step, error(step)});
  }
  return curve;
}

}  // namespace

class ErrorLawTest : public QObject {
  Q_OBJECT

 private slots:
  void findsTheOrderOfAPowerOfTheStep_data();
  void findsTheOrderOfAPowerOfTheStep();
  void isNotMisledByTheNextPower();
  void leavesOutErrorsThatRoundingDecides();
  void leavesOutErrorsBelowTheFloorGiven();
  void leavesOutErrorsThatHaveGrownToFullSize();
  void findsNoOrderWhereThereIsNone_data();
  void findsNoOrderWhereThereIsNone();
  void followsItsLineBothWays();
};

void ErrorLawTest::findsTheOrderOfAPowerOfTheStep_data() {
  QTest::addColumn<double>("order");
  for (const double order : {1.0, 2.0, 4.0, 5.0}) QTest::addRow("order %g", order) << order;
}

void ErrorLawTest::findsTheOrderOfAPowerOfTheStep() {
  QFETCH(double, order);
  const auto law = errorLaw(curveOf([=](double h) { return 7 * std::pow(h, order); }), 0);
  QVERIFY(law);
  QVERIFY(std::abs(law->order - order) < 1e-9);  // an exact power, but for rounding
  QCOMPARE(law->first, std::size_t{0});
  QCOMPARE(law->last, std::size_t{10});
}

void ErrorLawTest::isNotMisledByTheNextPower() {
  // Between its points the slope is from 3.6 to 3.9, and 4 only in the limit.
  const auto curve = curveOf([](double h) { return std::pow(h, 4) * (1 - 40 * h); });
  const std::vector<CurvePoint> fine(curve.begin() + 4, curve.begin() + 8);
  const auto law = errorLaw(fine, 0);
  QVERIFY(law);
  QVERIFY2(std::abs(law->order - 4) < 0.05, qPrintable(QString::number(law->order)));
}

void ErrorLawTest::leavesOutErrorsThatRoundingDecides() {
  const auto law = errorLaw(curveOf([](double h) { return std::pow(h, 4) + 1e-12; }), 0);
  QVERIFY(law);
  QVERIFY2(std::abs(law->order - 4) < 0.05, qPrintable(QString::number(law->order)));
  QVERIFY(law->error > 5e-12);
}

void ErrorLawTest::leavesOutErrorsBelowTheFloorGiven() {
  const auto law = errorLaw(curveOf([](double h) { return std::pow(h, 4); }), 1e-8);
  QVERIFY(law);
  QVERIFY(1e-8 <= law->error && law->error < 1.6e-7);  // the next point is 16 times finer
}

void ErrorLawTest::leavesOutErrorsThatHaveGrownToFullSize() {
  const auto law = errorLaw(curveOf([](double h) { return std::min(2.0, 500 * h); }), 0);
  QVERIFY(law);
  QVERIFY(std::abs(law->order - 1) < 1e-6);
  QCOMPARE(law->first, std::size_t{5});  // 1/256 s is the first with less than 2
}

void ErrorLawTest::findsNoOrderWhereThereIsNone_data() {
  QTest::addColumn<std::vector<CurvePoint>>("curve");
  QTest::newRow("no points") << std::vector<CurvePoint>{};
  QTest::newRow("three points") << curveOf([](double h) { return h; }, 3);
  QTest::newRow("the same everywhere") << curveOf([](double) { return 3.0; });
  QTest::newRow("up and down") << curveOf([](double h) { return 2 + std::sin(3 * std::log(h)); });
  QTest::newRow("growing") << curveOf([](double h) { return 1 / h; });
}

void ErrorLawTest::findsNoOrderWhereThereIsNone() {
  QFETCH(std::vector<CurvePoint>, curve);
  const auto law = errorLaw(curve, 0);
  QVERIFY2(!law, qPrintable(law ? QString::number(law->order) : QString()));
}

void ErrorLawTest::followsItsLineBothWays() {
  const ErrorLaw law{4, 0.01, 1e-6, 0, 3};
  QVERIFY(std::abs(law.errorAt(0.005) - 1e-6 / 16) < 1e-20);
  QVERIFY(std::abs(law.stepFor(1e-6 / 16) - 0.005) < 1e-16);
}

QTEST_APPLESS_MAIN(ErrorLawTest)
#include "error_law_test.moc"
