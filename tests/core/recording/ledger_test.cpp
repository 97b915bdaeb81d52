#include "core/recording/ledger.h"

#include <limits>

#include <QtTest>

using core::EnergySample;
using core::Ledger;

namespace {

EnergySample sampleAt(double time, double kinetic = 1) {
  EnergySample sample;
  sample.time = time;
  sample.energies.kinetic = kinetic;
  return sample;
}

/// A sample at 0 s, 1 s, …, up to but not at `end`.
void appendUpTo(Ledger& ledger, int end) {
  for (int i = 0; i < end; ++i) ledger.append(sampleAt(i));
}

}  // namespace

class LedgerTest : public QObject {
  Q_OBJECT

 private slots:
  void keepsEverySampleWhileThereIsRoom();
  void coversARunOfAnyLengthEvenly_data();
  void coversARunOfAnyLengthEvenly();
  void dropsTheFuture();
  void goesOnEvenlyAfterDropping();
  void knowsTheHighestEnergyEvenOfDroppedSamples();
  void countsLossesButNotDriftAsEnergy();
  void tellsTheDriftAsAShareOfTheStart();
  void givesTheAxisANumber();
  void startsAnew();
};

void LedgerTest::keepsEverySampleWhileThereIsRoom() {
  Ledger ledger(100);
  appendUpTo(ledger, 100);
  QCOMPARE(ledger.samples().size(), std::size_t{100});
  for (int i = 0; i < 100; ++i) QCOMPARE(ledger.samples()[i].time, double(i));
}

void LedgerTest::coversARunOfAnyLengthEvenly_data() {
  QTest::addColumn<int>("most");
  QTest::newRow("fewest") << 4;
  QTest::newRow("odd") << 7;
  QTest::newRow("even") << 16;
  QTest::newRow("many") << 101;
}

void LedgerTest::coversARunOfAnyLengthEvenly() {
  QFETCH(int, most);
  Ledger ledger(most);
  for (int i = 0; i < 5000; ++i) {
    ledger.append(sampleAt(i));
    const auto samples = ledger.samples();
    QVERIFY(static_cast<int>(samples.size()) <= most);
    QCOMPARE(samples.front().time, 0.0);
    QCOMPARE(samples.back().time, double(i));
    // All intervals are alike but the last, which is no longer than they.
    if (samples.size() < 3) continue;
    const double interval = samples[1].time - samples[0].time;
    for (std::size_t k = 2; k + 1 < samples.size(); ++k) {
      QCOMPARE(samples[k].time - samples[k - 1].time, interval);
    }
    QVERIFY(samples.back().time - samples[samples.size() - 2].time <= interval);
    // Never thinned more than needed: at least about half of the room is used.
    if (i >= most) QVERIFY(static_cast<int>(samples.size()) >= most / 2);
  }
}

void LedgerTest::dropsTheFuture() {
  Ledger ledger;
  appendUpTo(ledger, 10);
  ledger.dropAfter(6);
  QCOMPARE(ledger.samples().size(), std::size_t{7});
  QCOMPARE(ledger.samples().back().time, 6.0);
  ledger.dropAfter(-1);
  QVERIFY(ledger.samples().empty());
}

void LedgerTest::goesOnEvenlyAfterDropping() {
  Ledger ledger(8);
  appendUpTo(ledger, 20);  // every fourth is kept by now, and the latest
  ledger.dropAfter(12);
  for (int i = 13; i < 22; ++i) ledger.append(sampleAt(i));
  std::vector<double> times;
  for (const EnergySample& sample : ledger.samples()) times.push_back(sample.time);
  QCOMPARE(times, (std::vector<double>{0, 4, 8, 12, 16, 20, 21}));
}

void LedgerTest::knowsTheHighestEnergyEvenOfDroppedSamples() {
  Ledger ledger(4);
  for (int i = 0; i < 50; ++i) ledger.append(sampleAt(i, i == 13 ? 9 : 1));
  QCOMPARE(ledger.highest(), 9.0);
  ledger.append(sampleAt(50, 20));
  QCOMPARE(ledger.highest(), 20.0);
  ledger.dropAfter(48);
  QCOMPARE(ledger.highest(), 1.0);
}

void LedgerTest::countsLossesButNotDriftAsEnergy() {
  EnergySample sample = sampleAt(0, 1);
  sample.energies.potential = 2;
  sample.energies.lostToAir = 4;
  sample.energies.lostToImpacts = 8;
  sample.energies.lostToRopes = 16;
  sample.energies.lostToFriction = 32;
  sample.energies.numericalDrift = 64;
  Ledger ledger;
  ledger.append(sample);
  QCOMPARE(ledger.highest(), 63.0);
}

void LedgerTest::tellsTheDriftAsAShareOfTheStart() {
  core::Energies energies;
  energies.kinetic = 3;
  energies.lostToAir = 2;
  energies.numericalDrift = 1;  // so it began with 4 J
  QCOMPARE(energies.driftShare(), std::optional<double>(0.25));
  energies.numericalDrift = 5;
  QCOMPARE(energies.driftShare(), std::optional<double>());
}

void LedgerTest::givesTheAxisANumber() {
  Ledger ledger;
  ledger.append(sampleAt(0, 2));
  ledger.append(sampleAt(1, std::numeric_limits<double>::infinity()));
  ledger.append(sampleAt(2, std::numeric_limits<double>::quiet_NaN()));
  QCOMPARE(ledger.highest(), 2.0);
}

void LedgerTest::startsAnew() {
  Ledger ledger(4);
  appendUpTo(ledger, 100);
  ledger.clear();
  QVERIFY(ledger.samples().empty());
  QCOMPARE(ledger.highest(), 0.0);
  appendUpTo(ledger, 4);
  QCOMPARE(ledger.samples().size(), std::size_t{4});
}

QTEST_APPLESS_MAIN(LedgerTest)
#include "ledger_test.moc"
