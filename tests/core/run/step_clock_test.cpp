#include "core/run/step_clock.h"

#include <cmath>

#include <QtTest>

using core::StepClock;

namespace {

/// Frames of `frame` seconds in which the runs come only a share of the way asked for.
void play(StepClock& clock, double frame, int count, double share) {
  for (int i = 0; i < count; ++i) {
    const double from = clock.time();
    clock.reached(from + share * (clock.targetAfter(frame) - from));
  }
}

}  // namespace

class StepClockTest : public QObject {
  Q_OBJECT

 private slots:
  void followsTheWallClockTimesTheSpeed_data();
  void followsTheWallClockTimesTheSpeed();
  void showsTheSameTimeForAnyFrames();
  void aPauseCostsOneLongestFrame();
  void dropsWhatASlowMachineDidNotReach();
  void reportsTheShareKept_data();
  void reportsTheShareKept();
  void findsBackToRealTimeWithinSeconds();
  void countsFramesLongerThanTheLongestAsSlow();
  void forgetsOnePauseSoon();
  void staysAtRestWhenNoTimePasses();
  void startsAnew();
};

void StepClockTest::followsTheWallClockTimesTheSpeed_data() {
  QTest::addColumn<double>("speed");
  QTest::newRow("slow motion") << 1.0 / 64;
  QTest::newRow("real time") << 1.0;
  QTest::newRow("four times") << 4.0;
}

void StepClockTest::followsTheWallClockTimesTheSpeed() {
  QFETCH(double, speed);
  StepClock clock;
  clock.setSpeed(speed);
  clock.reset(2);
  const double target = clock.targetAfter(0.02);
  QCOMPARE(target, 2 + 0.02 * speed);
  clock.reached(target);
  QCOMPARE(clock.time(), target);
  QCOMPARE(clock.keptShare(), 1.0);
}

void StepClockTest::showsTheSameTimeForAnyFrames() {
  StepClock even;
  play(even, 1.0 / 64, 64 * 60, 1);
  StepClock uneven;
  for (int i = 0; i < 600; ++i) {
    play(uneven, 1.0 / 128, 3, 1);
    play(uneven, 1.0 / 64 + 1.0 / 16 - 1.0 / 512, 1, 1);
    play(uneven, 1.0 / 512, 1, 1);
  }
  QCOMPARE(even.time(), 60.0);
  QCOMPARE(uneven.time(), 600 * (3.0 / 128 + 5.0 / 64));
  // Exactly: while every frame is reached the mean has nothing to round.
  QCOMPARE(even.keptShare(), 1.0);
  QCOMPARE(uneven.keptShare(), 1.0);
}

void StepClockTest::aPauseCostsOneLongestFrame() {
  StepClock clock(0.1);
  clock.setSpeed(2);
  QCOMPARE(clock.targetAfter(3600), 0.2);
}

void StepClockTest::dropsWhatASlowMachineDidNotReach() {
  StepClock clock;
  clock.targetAfter(0.05);
  clock.reached(0.01);
  QCOMPARE(clock.time(), 0.01);
  QCOMPARE(clock.targetAfter(0.05), 0.06);
}

void StepClockTest::reportsTheShareKept_data() {
  QTest::addColumn<double>("share");
  QTest::addColumn<double>("speed");
  QTest::newRow("a quarter") << 0.25 << 1.0;
  QTest::newRow("half of four times") << 0.5 << 4.0;
  QTest::newRow("nothing") << 0.0 << 1.0;
}

void StepClockTest::reportsTheShareKept() {
  QFETCH(double, share);
  QFETCH(double, speed);
  StepClock clock;
  clock.setSpeed(speed);
  play(clock, 1.0 / 60, 30, share);
  // Half a second has passed: under half the way from 1 to the share is left.
  QVERIFY(clock.keptShare() > share + 0.5 * (1 - share));
  QVERIFY(clock.keptShare() < share + 0.7 * (1 - share));
  play(clock, 1.0 / 60, 600, share);
  // Ten seconds more: e^−10 of the way is left.
  QVERIFY(std::abs(clock.keptShare() - share) < 1e-4);
}

void StepClockTest::findsBackToRealTimeWithinSeconds() {
  StepClock clock;
  play(clock, 0.02, 500, 0.2);
  play(clock, 0.02, 250, 1);
  QVERIFY(clock.keptShare() > 0.99);
}

void StepClockTest::countsFramesLongerThanTheLongestAsSlow() {
  StepClock clock(0.1);
  play(clock, 0.4, 200, 1);
  QVERIFY(std::abs(clock.keptShare() - 0.25) < 1e-6);
}

void StepClockTest::forgetsOnePauseSoon() {
  StepClock clock(0.1);
  play(clock, 3600, 1, 1);
  QVERIFY(clock.keptShare() > 0.9);
  play(clock, 0.02, 150, 1);
  QVERIFY(clock.keptShare() > 0.99);
}

void StepClockTest::staysAtRestWhenNoTimePasses() {
  StepClock clock;
  clock.reset(5);
  QCOMPARE(clock.targetAfter(0), 5.0);
  clock.reached(5);
  QCOMPARE(clock.time(), 5.0);
  QCOMPARE(clock.keptShare(), 1.0);
}

void StepClockTest::startsAnew() {
  StepClock clock;
  play(clock, 0.05, 100, 0.5);
  clock.reset(0);
  QCOMPARE(clock.time(), 0.0);
  QCOMPARE(clock.keptShare(), 1.0);
}

QTEST_APPLESS_MAIN(StepClockTest)
#include "step_clock_test.moc"
