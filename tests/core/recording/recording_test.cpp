#include "core/recording/recording.h"

#include <map>
#include <memory>
#include <vector>

#include <QtTest>

#include "tests/support/fingerprint.h"
#include "tests/support/random_scene.h"

using core::EventKind;
using core::Recording;
using core::Run;
using core::Scene;
using tests::fingerprint;

namespace {

constexpr int kSteps = 200;

/// Six weights of a made-up scene, cut by hand only.
Run newRun(const QByteArray& method = "rk4") {
  Scene scene = tests::randomScene(1, 6);
  scene.cutTime.reset();
  return Run(std::make_shared<const Scene>(std::move(scene)),
             {.method = method.toStdString(), .step = 1.0 / 60});
}

/// A run, its recording, and what it showed after each step.
struct Lane {
  Run run;
  Recording recording;
  std::map<std::int64_t, std::vector<double>> shown;

  explicit Lane(std::size_t budget, const QByteArray& method = "rk4")
      : run(newRun(method)), recording(budget) {
    recording.start(run);
    shown[0] = fingerprint(run);
  }

  void advance(int steps) {
    for (int i = 0; i < steps; ++i) {
      run.advance();
      recording.record(run);
      shown[run.stepCount()] = fingerprint(run);
    }
  }

  void cutAll() {
    recording.cutAll(run);
    shown[run.stepCount()] = fingerprint(run);
  }

  void cut(int weight) {
    recording.cut(run, weight);
    shown[run.stepCount()] = fingerprint(run);
  }
};

std::size_t stateSize() {
  return newRun().state().bytes();
}

std::ptrdiff_t countOf(const Recording& recording, EventKind kind) {
  return std::ranges::count(recording.eventLog().events(), kind, &core::Event::kind);
}

}  // namespace

class RecordingTest : public QObject {
  Q_OBJECT

 private slots:
  void restoresAnyStepExactly_data();
  void restoresAnyStepExactly();
  void restoresStepsAfterCutsByHand_data();
  void restoresStepsAfterCutsByHand();
  void restoresThePathsThatLedThere();
  void goesOnFromARestoredStep();
  void takesRecordedStepsAgainWithTheirCuts();
  void restoresInPieces();
  void recordsNoStepTwice();
  void forgetsTheFutureAfterACut();
  void listsEachCutOnce();
  void startsAnew();
};

void RecordingTest::restoresAnyStepExactly_data() {
  QTest::addColumn<QByteArray>("method");
  QTest::addColumn<std::size_t>("budget");
  for (const std::string method : {"euler", "rk4"}) {
    const QByteArray id = QByteArray::fromStdString(method);
    QTest::addRow("%s, room for two states", method.c_str()) << id << std::size_t{0};
    QTest::addRow("%s, for ten", method.c_str()) << id << 10 * stateSize();
    QTest::addRow("%s, for all", method.c_str()) << id << 1000 * stateSize();
  }
}

void RecordingTest::restoresAnyStepExactly() {
  QFETCH(QByteArray, method);
  QFETCH(std::size_t, budget);
  Lane lane(budget, method);
  lane.advance(kSteps);
  QCOMPARE(lane.recording.firstStep(), std::int64_t{0});
  QCOMPARE(lane.recording.lastStep(), std::int64_t{kSteps});
  // Forwards and backwards over the whole run.
  for (int i = 0; i <= kSteps; ++i) {
    const int step = 37 * i % (kSteps + 1);
    lane.recording.restore(lane.run, step);
    QCOMPARE(lane.run.stepCount(), std::int64_t{step});
    QVERIFY(fingerprint(lane.run) == lane.shown[step]);
  }
}

void RecordingTest::restoresStepsAfterCutsByHand_data() {
  restoresAnyStepExactly_data();
}

void RecordingTest::restoresStepsAfterCutsByHand() {
  QFETCH(QByteArray, method);
  QFETCH(std::size_t, budget);
  Lane lane(budget, method);
  lane.cut(0);
  lane.advance(30);
  lane.cut(1);
  lane.cut(2);
  lane.advance(33);
  lane.cutAll();
  lane.advance(kSteps - 63);
  for (const auto& [step, numbers] : lane.shown) {
    lane.recording.restore(lane.run, step);
    QVERIFY2(fingerprint(lane.run) == numbers, qPrintable(QString::number(step)));
  }
}

void RecordingTest::restoresThePathsThatLedThere() {
  Lane lane(3 * stateSize());
  lane.advance(40);
  const double inside = lane.run.time() - 0.3 / 60;
  std::vector<Eigen::Vector2d> places;
  bool moved = false;
  for (int i = 0; i < lane.run.weightCount(); ++i) {
    places.push_back(lane.run.weightAt(i, inside).position);
    moved = moved || places.back() != lane.run.weight(i).position;
  }
  QVERIFY(moved);
  lane.advance(40);
  lane.recording.restore(lane.run, 40);
  for (int i = 0; i < lane.run.weightCount(); ++i)
    QCOMPARE(lane.run.weightAt(i, inside).position, places[i]);
}

void RecordingTest::goesOnFromARestoredStep() {
  Lane lane(3 * stateSize());
  lane.advance(kSteps);
  lane.recording.restore(lane.run, 77);
  for (int step = 78; step <= kSteps; ++step) {
    lane.run.advance();
    QVERIFY(fingerprint(lane.run) == lane.shown[step]);
  }
}

void RecordingTest::takesRecordedStepsAgainWithTheirCuts() {
  Lane lane(3 * stateSize());
  lane.advance(50);
  lane.cut(1);
  lane.advance(50);
  lane.cutAll();
  lane.advance(20);
  lane.recording.restore(lane.run, 10);
  for (int step = 11; step <= 120; ++step) {
    QCOMPARE(lane.recording.advance(lane.run), core::RunStatus::kRunning);
    QVERIFY(fingerprint(lane.run) == lane.shown[step]);
  }
  QCOMPARE(lane.recording.lastStep(), std::int64_t{120});
  lane.recording.advance(lane.run);
  QCOMPARE(lane.recording.lastStep(), std::int64_t{121});
}

void RecordingTest::restoresInPieces() {
  Lane lane(3 * stateSize());
  lane.advance(kSteps);
  Run other = newRun();
  for (const int step : {0, 1, 77, 128, kSteps}) {
    const std::int64_t kept = lane.recording.keptStepBefore(step);
    QVERIFY(step == 0 ? kept == 0 : kept < step);
    lane.recording.beginRestore(other, step);
    QCOMPARE(other.stepCount(), kept);
    for (std::int64_t i = kept; i < step; ++i) lane.recording.replay(other);
    QVERIFY(fingerprint(other) == lane.shown[step]);
  }
}

void RecordingTest::recordsNoStepTwice() {
  Lane lane(10 * stateSize());
  lane.advance(kSteps);
  const std::size_t samples = lane.recording.ledger().samples().size();
  const std::size_t events = lane.recording.eventLog().events().size();
  lane.recording.restore(lane.run, 20);
  lane.advance(50);
  QCOMPARE(lane.recording.lastStep(), std::int64_t{kSteps});
  QCOMPARE(lane.recording.ledger().samples().size(), samples);
  QCOMPARE(lane.recording.eventLog().events().size(), events);
  lane.advance(kSteps - 70 + 1);
  QCOMPARE(lane.recording.lastStep(), std::int64_t{kSteps + 1});
  QCOMPARE(lane.recording.ledger().samples().size(), samples + 1);
}

void RecordingTest::forgetsTheFutureAfterACut() {
  Lane lane(10 * stateSize());
  lane.advance(100);
  lane.cut(1);
  lane.advance(kSteps - 100);
  lane.recording.restore(lane.run, 50);
  const double now = lane.run.time();
  lane.cutAll();
  QCOMPARE(lane.recording.lastStep(), std::int64_t{50});
  QCOMPARE(lane.recording.ledger().samples().back().time, now);
  for (const core::Event& event : lane.recording.eventLog().events()) QVERIFY(event.time <= now);

  lane.advance(kSteps - 50);
  QVERIFY(lane.run.allCut());
  for (int step = 0; step <= kSteps; ++step) {
    lane.recording.restore(lane.run, step);
    QVERIFY(fingerprint(lane.run) == lane.shown[step]);
  }
}

void RecordingTest::listsEachCutOnce() {
  Lane lane(10 * stateSize());
  lane.advance(20);
  lane.cut(0);
  lane.advance(20);
  QCOMPARE(countOf(lane.recording, EventKind::kCut), std::ptrdiff_t{1});
  lane.recording.restore(lane.run, 20);
  lane.cut(1);
  lane.advance(20);
  QCOMPARE(countOf(lane.recording, EventKind::kCut), std::ptrdiff_t{2});
  const auto events = lane.recording.eventLog().events();
  QVERIFY(std::ranges::is_sorted(events, {}, &core::Event::time));
}

void RecordingTest::startsAnew() {
  Lane lane(10 * stateSize());
  lane.cutAll();
  lane.advance(kSteps);
  Run other = newRun();
  other.advance();
  lane.recording.start(other);
  QCOMPARE(lane.recording.firstStep(), std::int64_t{1});
  QCOMPARE(lane.recording.lastStep(), std::int64_t{1});
  QCOMPARE(lane.recording.ledger().samples().size(), std::size_t{1});
  QVERIFY(lane.recording.eventLog().events().empty());
  const std::vector<double> shown = fingerprint(other);
  other.advance();
  lane.recording.record(other);
  lane.recording.restore(other, 1);
  QCOMPARE(other.time(), shown[0]);
  QVERIFY(!other.allCut());
}

QTEST_APPLESS_MAIN(RecordingTest)
#include "recording_test.moc"
