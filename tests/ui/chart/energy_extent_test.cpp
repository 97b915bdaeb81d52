#include "ui/chart/energy_extent.h"

#include <limits>

#include <QTest>

#include "tests/ui/chart/sample_ledgers.h"

using core::Ledger;
using ui::EnergyExtent;
using ui::extentOf;

class EnergyExtentTest : public QObject {
  Q_OBJECT

 private slots:
  void coversAllRuns();
  void isEmptyWithoutSamples();
  void showsRopesAndFrictionOnlyOnceTheyAreNotZero();
  void takesOffAHeightThatWouldHideTheMovement();
  void waitsForTheFirstSwingToTurn();
  void keepsTheFloorAsZeroForMovementsOfItsSize();
  void endsTheScaleWhereARunLeavesAllProportion();
  void ignoresWhatIsNoNumber();
  void tellsUntilWhenARunIsSound();
  void readsAGrowingLedgerToTheSameEnd();
};

void EnergyExtentTest::coversAllRuns() {
  const Ledger first = sample_ledgers::swinging(4, 401);
  const Ledger second = sample_ledgers::swinging(8, 801, 1, 0.5);
  const EnergyExtent extent = extentOf({{&first, "a"}, {&second, "b"}});

  QCOMPARE(extent.lastTime, 8.0);
  QCOMPARE(extent.lowest, 0.0);
  QCOMPARE(extent.highest, 3 + 0.5 * 8);
  QCOMPARE(extent.highestOfRun.size(), std::size_t{2});
  QCOMPARE(extent.highestOfRun[0], 3.0);
  QCOMPARE(extent.highestOfRun[1], 7.0);
  QVERIFY(!extent.ceiling);
}

void EnergyExtentTest::isEmptyWithoutSamples() {
  const Ledger empty;
  const EnergyExtent extent = extentOf({{&empty, "a"}});

  QCOMPARE(extent.lastTime, 0.0);
  QCOMPARE(extent.lowest, 0.0);
  QCOMPARE(extent.highest, 0.0);
  QCOMPARE(extent.offset, 0.0);
}

void EnergyExtentTest::showsRopesAndFrictionOnlyOnceTheyAreNotZero() {
  Ledger ledger = sample_ledgers::swinging(1, 11);
  using Shown = std::array<bool, ui::kEnergyQuantityCount>;
  QCOMPARE(extentOf({{&ledger, "a"}}).shown, (Shown{true, true, true, true, false, false, true}));

  core::Energies energies;
  energies.lostToRopes = 0.1;
  ledger.append({2, energies});
  QCOMPARE(extentOf({{&ledger, "a"}}).shown, (Shown{true, true, true, true, true, false, true}));
}

void EnergyExtentTest::takesOffAHeightThatWouldHideTheMovement() {
  const Ledger ledger = sample_ledgers::swinging(4, 401, 1862.3);
  const EnergyExtent extent = extentOf({{&ledger, "a"}});

  QCOMPARE(extent.offset, 1862.0);
  QVERIFY(extent.lowest == 0);
  QVERIFY(std::abs(extent.highest - 2.3) < 1e-9);
}

void EnergyExtentTest::waitsForTheFirstSwingToTurn() {
  // Two runs that both fall: the second's start is no way up from where the first ended.
  const Ledger falling = sample_ledgers::swinging(0.5, 51, 1862.3);
  QCOMPARE(extentOf({{&falling, "a"}, {&falling, "b"}}).offset, 0.0);
}

void EnergyExtentTest::keepsTheFloorAsZeroForMovementsOfItsSize() {
  const Ledger ledger = sample_ledgers::swinging(4, 401, 9);
  QCOMPARE(extentOf({{&ledger, "a"}}).offset, 0.0);
}

void EnergyExtentTest::endsTheScaleWhereARunLeavesAllProportion() {
  const Ledger steady = sample_ledgers::swinging(4, 401);
  const Ledger diverging = sample_ledgers::diverging();
  const EnergyExtent extent = extentOf({{&steady, "a"}, {&diverging, "b"}});

  QVERIFY(extent.ceiling.has_value());
  QCOMPARE(*extent.ceiling, 3 * ui::kMostGain);
}

void EnergyExtentTest::ignoresWhatIsNoNumber() {
  Ledger ledger = sample_ledgers::swinging(4, 401);
  core::Energies energies;
  energies.kinetic = std::numeric_limits<double>::quiet_NaN();
  ledger.append({5, energies});
  energies.kinetic = std::numeric_limits<double>::infinity();
  ledger.append({6, energies});
  const EnergyExtent extent = extentOf({{&ledger, "a"}});

  QCOMPARE(extent.lastTime, 4.0);
  QCOMPARE(extent.highest, 3.0);
}

void EnergyExtentTest::tellsUntilWhenARunIsSound() {
  const Ledger steady = sample_ledgers::swinging(4, 401);
  const Ledger diverging = sample_ledgers::diverging();  // 1 + 2 · 2^t J
  const EnergyExtent extent = extentOf({{&steady, "a"}, {&diverging, "b"}});
  QCOMPARE(extent.soundUntil[0], std::numeric_limits<double>::infinity());
  QCOMPARE(extent.soundUntil[1], 4.0);  // 33 J of 3
}

void EnergyExtentTest::readsAGrowingLedgerToTheSameEnd() {
  const Ledger all = sample_ledgers::swinging(4, 401, 1862.3, 0.1);
  Ledger growing(64);  // thinned on the way
  Ledger grown(64);
  const EnergyExtent whole = extentOf({{&all, "a"}});
  ui::GrowingEnergyExtent extents;
  for (const core::EnergySample& sample : all.samples()) {
    growing.append(sample);
    grown.append(sample);
    const EnergyExtent extent = extents.of({{&growing, "a"}});
    const EnergyExtent anew = extentOf({{&grown, "a"}});
    QCOMPARE(extent.lastTime, anew.lastTime);
    QVERIFY(extent.highest >= anew.highest);
    QVERIFY(extent.highest + extent.offset <= whole.highest + whole.offset);
    QCOMPARE(extent.offset, anew.offset);
  }
  growing.clear();
  QCOMPARE(extents.of({{&growing, "a"}}).lastTime, 0.0);
}

QTEST_GUILESS_MAIN(EnergyExtentTest)
#include "energy_extent_test.moc"
