#include "ui/chart/energy_scales.h"

#include <QTest>

#include "ui/chart/energy_extent.h"

using ui::EnergyExtent;
using ui::EnergyScales;
using ui::energyScales;

class EnergyScalesTest : public QObject {
  Q_OBJECT

 private slots:
  void leaveRoomAboveTheHighestCurve();
  void reachTheLeastTime();
  void chooseUnitsByTheirEnds_data();
  void chooseUnitsByTheirEnds();
  void endAtTheCeiling();
};

void EnergyScalesTest::leaveRoomAboveTheHighestCurve() {
  EnergyExtent extent;
  extent.highest = 3;
  QVERIFY(energyScales(extent, 0, 5, 6).energy.highest > 3);
}

void EnergyScalesTest::reachTheLeastTime() {
  EnergyExtent extent;
  extent.lastTime = 0.3;
  QCOMPARE(energyScales(extent, 2, 4, 4).time.highest, 2.0);
  QCOMPARE(energyScales(extent, 0, 3, 4).time.highest, 0.3);
}

void EnergyScalesTest::chooseUnitsByTheirEnds_data() {
  QTest::addColumn<double>("lastTime");
  QTest::addColumn<double>("highest");
  QTest::addColumn<QString>("timeUnit");
  QTest::addColumn<QString>("energyUnit");
  QTest::addColumn<double>("energyEnd");

  QTest::newRow("classroom") << 8.0 << 2.8 << "s"
                             << "J" << 3.0;
  QTest::newRow("an hour, tons") << 3600.0 << 2.8e6 << "s"
                                 << "MJ" << 3.0;
  QTest::newRow("a step, grains") << 1e-3 << 2.8e-8 << "ms"
                                  << "nJ" << 30.0;
}

void EnergyScalesTest::chooseUnitsByTheirEnds() {
  QFETCH(double, lastTime);
  QFETCH(double, highest);
  QFETCH(double, energyEnd);
  EnergyExtent extent;
  extent.lastTime = lastTime;
  extent.highest = highest;
  const EnergyScales scales = energyScales(extent, 0, 5, 6);

  QTEST(scales.timeUnit.symbol, "timeUnit");
  QTEST(scales.energyUnit.symbol, "energyUnit");
  QCOMPARE(scales.energy.highest, energyEnd);
}

void EnergyScalesTest::endAtTheCeiling() {
  EnergyExtent extent;
  extent.highest = 1e300;
  extent.ceiling = 30;
  QCOMPARE(energyScales(extent, 0, 5, 6).energy.highest, 30.0);
}

QTEST_GUILESS_MAIN(EnergyScalesTest)
#include "energy_scales_test.moc"
