#include "ui/chart/chart_scales.h"

#include <QTest>

using ui::AxisEnds;
using ui::AxisScale;
using ui::ChartAxis;

namespace {

const ChartAxis kEnergy = {"Energy", "J"};
const ChartAxis kTime = {"Time", "s"};

}  // namespace

class ChartScalesTest : public QObject {
  Q_OBJECT

 private slots:
  void endsOnTicksOrJustWhereAsked();
  void choosesUnitsByTheirEnds_data();
  void choosesUnitsByTheirEnds();
  void keepsSecondsPlain_data();
  void keepsSecondsPlain();
  void namesQuantityAndUnit();
};

void ChartScalesTest::endsOnTicksOrJustWhereAsked() {
  const AxisScale nice = ui::axisScale(kEnergy, 0.3, 2.7, 6, AxisEnds::kOnTicks);
  QCOMPARE(nice.lowest, 0.0);
  QCOMPARE(nice.highest, 3.0);
  QCOMPARE(nice.ticks.step, 0.5);
  const AxisScale exact = ui::axisScale(kEnergy, 0.3, 2.7, 6, AxisEnds::kExact);
  QCOMPARE(exact.lowest, 0.3);
  QCOMPARE(exact.highest, 2.7);
  QCOMPARE(exact.ticks.step, 0.5);
}

void ChartScalesTest::choosesUnitsByTheirEnds_data() {
  QTest::addColumn<double>("lowest");
  QTest::addColumn<double>("highest");
  QTest::addColumn<bool>("prefixed");
  QTest::addColumn<QString>("unit");
  QTest::addColumn<double>("end");

  QTest::newRow("classroom") << 0.0 << 2.8 << true << "J" << 3.0;
  QTest::newRow("tons") << 0.0 << 2.8e6 << true << "MJ" << 3.0;
  QTest::newRow("grains") << 0.0 << 2.8e-8 << true << "nJ" << 30.0;
  QTest::newRow("below zero") << -2.8e6 << 0.0 << true << "MJ" << 0.0;
  QTest::newRow("angles") << 0.0 << 28000.0 << false << "J" << 30000.0;
}

void ChartScalesTest::choosesUnitsByTheirEnds() {
  QFETCH(double, lowest);
  QFETCH(double, highest);
  QFETCH(bool, prefixed);
  const ChartAxis axis{"Energy", "J", prefixed};
  const AxisScale scale = ui::axisScale(axis, lowest, highest, 6, AxisEnds::kOnTicks);
  QTEST(scale.unit.symbol, "unit");
  QTEST(scale.highest, "end");
}

void ChartScalesTest::keepsSecondsPlain_data() {
  QTest::addColumn<double>("end");
  QTest::addColumn<QString>("unit");
  QTest::newRow("a step") << 1e-3 << "ms";
  QTest::newRow("a swing") << 2.0 << "s";
  QTest::newRow("hours") << 36000.0 << "s";
}

void ChartScalesTest::keepsSecondsPlain() {
  QFETCH(double, end);
  QTEST(ui::timeScale(kTime, 0, end, 5, AxisEnds::kOnTicks).unit.symbol, "unit");
}

void ChartScalesTest::namesQuantityAndUnit() {
  const AxisScale scale = ui::axisScale(kEnergy, 0, 3000000, 6, AxisEnds::kOnTicks);
  QCOMPARE(scale.title("Energy"), QString("Energy (MJ)"));
}

QTEST_GUILESS_MAIN(ChartScalesTest)
#include "chart_scales_test.moc"
