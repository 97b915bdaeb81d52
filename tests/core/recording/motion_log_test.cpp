#include "core/recording/motion_log.h"

#include <memory>

#include <QtTest>

#include "core/recording/recording.h"
#include "core/scene/arrangement.h"

using core::MotionLog;
using core::MotionSample;
using core::Recording;
using core::Run;

namespace {

Run runOf(int weights) {
  core::Scene scene = core::withWeightCount(core::Scene(), weights);
  return Run(std::make_shared<const core::Scene>(std::move(scene)), {.step = 1.0 / 60});
}

void advance(Run& run, Recording& recording, int steps) {
  for (int i = 0; i < steps; ++i) {
    run.advance();
    recording.record(run);
  }
}

bool isSame(const core::WeightState& a, const core::WeightState& b) {
  return a.phase == b.phase && a.position == b.position && a.velocity == b.velocity &&
         a.angle == b.angle && a.angularVelocity == b.angularVelocity;
}

}  // namespace

class MotionLogTest : public QObject {
  Q_OBJECT

 private slots:
  void tellsWhereAWeightWasAtEveryStep();
  void followsTheFirstWeightsFromTheStart();
  void followsAnotherWeightFromItsKeptPast();
  void forgetsTheFutureWithACut();
  void keepsWhatIsSettledUntilItsRevisionChanges();
};

void MotionLogTest::tellsWhereAWeightWasAtEveryStep() {
  Run run = runOf(3);
  Recording recording;
  recording.start(run);
  for (int step = 1; step <= 50; ++step) {
    advance(run, recording, 1);
    const auto samples = recording.motion().track(2)->samples();
    QCOMPARE(samples.size(), static_cast<std::size_t>(step + 1));
    QCOMPARE(samples.back().time, run.time());
    QVERIFY(isSame(samples.back().weight, run.weight(2)));
  }
}

void MotionLogTest::followsTheFirstWeightsFromTheStart() {
  Run run = runOf(30);
  Recording recording;
  recording.start(run);
  QVERIFY(recording.motion().track(0) != nullptr);
  QVERIFY(recording.motion().track(MotionLog::kMostFromStart - 1) != nullptr);
  QVERIFY(recording.motion().track(MotionLog::kMostFromStart) == nullptr);
}

void MotionLogTest::followsAnotherWeightFromItsKeptPast() {
  Run run = runOf(30);
  Recording recording;
  recording.start(run);
  std::vector<core::WeightState> seen = {run.weight(27)};
  for (int step = 1; step <= 40; ++step) {
    if (step == 20) recording.follow(run, 27);
    advance(run, recording, 1);
    seen.push_back(run.weight(27));
  }
  const auto samples = recording.motion().track(27)->samples();
  QCOMPARE(samples.size(), seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i) QVERIFY(isSame(samples[i].weight, seen[i]));
}

void MotionLogTest::forgetsTheFutureWithACut() {
  Run run = runOf(3);
  Recording recording;
  recording.start(run);
  advance(run, recording, 30);
  const std::uint64_t revision = recording.motion().track(1)->revision();
  recording.restore(run, 10);
  recording.cutAll(run);
  QCOMPARE(recording.motion().track(1)->samples().back().time, 10 * (1.0 / 60));
  QVERIFY(recording.motion().track(1)->revision() != revision);
}

void MotionLogTest::keepsWhatIsSettledUntilItsRevisionChanges() {
  core::EvenSeries<MotionSample> series(8);
  std::vector<double> known;
  std::uint64_t revision = series.revision();
  int changes = 0;
  for (int i = 0; i < 200; ++i) {
    series.append({double(i), {}});
    if (series.revision() != revision) {
      revision = series.revision();
      known.clear();
      ++changes;
    }
    for (std::size_t k = 0; k < known.size(); ++k) QCOMPARE(series.samples()[k].time, known[k]);
    for (std::size_t k = known.size(); k < series.settled(); ++k) {
      known.push_back(series.samples()[k].time);
    }
    QCOMPARE(series.samples().back().time, double(i));
  }
  QCOMPARE(changes, 5);  // 8, 16, … 128 samples were too many
}

QTEST_APPLESS_MAIN(MotionLogTest)
#include "motion_log_test.moc"
