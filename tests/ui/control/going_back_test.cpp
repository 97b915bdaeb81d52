#include <map>
#include <memory>
#include <vector>

#include <QSignalSpy>
#include <QTest>

#include "tests/support/controlled_runs.h"
#include "tests/support/fingerprint.h"
#include "tests/support/impacts.h"
#include "tests/support/random_scene.h"
#include "ui/control/run_controller.h"

using tests::isImpact;
using tests::lightBallInThickAir;
using tests::ticking;
using ui::RunController;

namespace {

using Bits = std::vector<double>;

/// Six made-up weights under four methods with three different steps.
std::shared_ptr<core::Scene> fourRuns() {
  auto scene = std::make_shared<core::Scene>(tests::randomScene(1, 6));
  scene->cutTime.reset();
  scene->solvers = {{.method = "rk4", .step = 1.0 / 60},
                    {.method = "euler", .step = 1.0 / 60},
                    {.method = "dopri5", .step = 0.007},
                    {.method = "semi-implicit-euler", .step = 0.1}};
  return scene;
}

/// Everything that can be seen of all runs at the moment shown.
Bits shown(const RunController& controller) {
  Bits bits{controller.time()};
  for (const core::Run* run : controller.runs()) {
    for (int i = 0; i < run->weightCount(); ++i) {
      const core::WeightState weight = run->weightAt(i, controller.time());
      bits.insert(bits.end(), {weight.position.x(), weight.position.y(), weight.velocity.x(),
                               weight.velocity.y(), static_cast<double>(weight.phase)});
    }
    bits.push_back(run->energiesAt(controller.time()).accounted());
  }
  return bits;
}

/// The same, how the runs stand after their latest steps, and all that is recorded.
Bits everything(const RunController& controller) {
  Bits bits = shown(controller);
  const Bits recorded = tests::recordedBits(controller);
  bits.insert(bits.end(), recorded.begin(), recorded.end());
  return bits;
}

void playUntil(RunController& controller, double time, double frame = 1.0 / 60) {
  controller.play();
  while (controller.time() < time) {
    controller.passTime(std::min(frame, (time - controller.time()) / controller.speed()));
  }
  controller.pause();
}

}  // namespace

class GoingBackTest : public QObject {
  Q_OBJECT

 private slots:
  void restoresEveryShownMomentExactly();
  void playsOnWithTheSameBits_data();
  void playsOnWithTheSameBits();
  void playsOnThroughACutByHand();
  void aCutInThePastForgetsTheFuture();
  void stepsBackByTheStepsOfTheFirstRun();
  void stepsBackByFrames();
  void staysWithinTheRecord();
  void keepsPlayingWhenAnotherMomentIsShown();
  void aStoppedRunGoesOnAtAnEarlierMoment();
  void stoppedRunsDoNotHoldUpTheWayAhead();
  void longWaysGoOnInLaterFrames();
  void aGoalThatMovesOnIsFollowed();
  void computesOnToALaterMoment();
  void goesToTheNextWantedEvent();
  void isPastAnEventAtTheMomentShown();
  void saysWhenThereIsNoSuchEvent();
};

void GoingBackTest::restoresEveryShownMomentExactly() {
  RunController controller(ticking(0));
  controller.setScene(fourRuns());
  std::map<double, Bits> seen;
  controller.play();
  for (int frame = 0; frame < 150; ++frame) {
    controller.passTime(frame % 3 == 0 ? 0.03 : 0.011);
    seen[controller.time()] = shown(controller);
    if (frame == 60) controller.cutAll();
  }
  controller.pause();
  std::vector<double> times;
  for (const auto& [time, bits] : seen) times.push_back(time);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double time = times[i * 37 % times.size()];
    controller.showTime(time);
    QCOMPARE(controller.time(), time);
    QVERIFY(shown(controller) == seen[time]);
  }
}

void GoingBackTest::playsOnWithTheSameBits_data() {
  QTest::addColumn<double>("perLook");
  QTest::newRow("with all the time it needs") << 0.0;
  QTest::newRow("with work spread over frames") << 0.004;
}

void GoingBackTest::playsOnWithTheSameBits() {
  QFETCH(double, perLook);
  RunController straight(ticking(0));
  straight.setScene(fourRuns());
  playUntil(straight, 3);
  RunController wandering(ticking(perLook));
  wandering.setScene(fourRuns());
  playUntil(wandering, 2);
  for (const double time : {0.7, 1.9, 0.0, 0.31}) {
    wandering.showTime(time);
    while (wandering.isTravelling()) wandering.passTime(0.016);
    QCOMPARE(wandering.time(), time);
  }
  playUntil(wandering, 3, 0.013);
  QVERIFY(everything(wandering) == everything(straight));
}

void GoingBackTest::playsOnThroughACutByHand() {
  RunController straight(ticking(0)), wandering(ticking(0));
  for (RunController* controller : {&straight, &wandering}) {
    controller->setScene(fourRuns());
    playUntil(*controller, 1);
    controller->cutAll();
    playUntil(*controller, 2);
  }
  wandering.showTime(0.5);
  QVERIFY(!wandering.run(0).allCut());
  playUntil(wandering, 2.5);
  playUntil(straight, 2.5);
  QVERIFY(everything(wandering) == everything(straight));
}

void GoingBackTest::aCutInThePastForgetsTheFuture() {
  RunController straight(ticking(0)), wandering(ticking(0));
  for (RunController* controller : {&straight, &wandering}) {
    controller->setScene(fourRuns());
    playUntil(*controller, 0.5);
  }
  playUntil(wandering, 2);
  wandering.showTime(0.5);
  QVERIFY(wandering.canCut());
  wandering.cutAll();
  straight.cutAll();
  QVERIFY(wandering.recordedUntil() < 0.7);
  playUntil(wandering, 2.5);
  playUntil(straight, 2.5);
  QVERIFY(everything(wandering) == everything(straight));
}

void GoingBackTest::stepsBackByTheStepsOfTheFirstRun() {
  RunController controller(ticking(0));
  controller.setScene(fourRuns());
  playUntil(controller, 0.51);
  for (int step = 30; step >= 0; --step) {
    controller.stepBack();
    QCOMPARE(controller.time(), step * (1.0 / 60));
    QCOMPARE(controller.run(0).stepCount(), step);
  }
  controller.stepBack();
  QCOMPARE(controller.time(), 0.0);
  controller.stepOnce();
  QCOMPARE(controller.time(), 1.0 / 60);
}

void GoingBackTest::stepsBackByFrames() {
  RunController controller(ticking(0));
  controller.setScene(fourRuns());
  playUntil(controller, 0.5);
  controller.setSpeed(1.0 / 64);
  controller.stepFrameBack();
  QCOMPARE(controller.time(), 0.5 - 1.0 / 60 / 64);
  controller.stepFrame();
  QCOMPARE(controller.time(), 0.5);
}

void GoingBackTest::staysWithinTheRecord() {
  RunController controller(ticking(0));
  controller.setScene(fourRuns());
  playUntil(controller, 0.5);
  const double end = controller.recordedUntil();
  QVERIFY(0.5 <= end && end < 0.52);
  controller.showTime(100);
  QCOMPARE(controller.time(), end);
  controller.showTime(-1);
  QCOMPARE(controller.time(), 0.0);
}

void GoingBackTest::keepsPlayingWhenAnotherMomentIsShown() {
  RunController controller(ticking(0));
  controller.setScene(fourRuns());
  playUntil(controller, 1);
  controller.play();
  QSignalSpy told(&controller, &RunController::timeShown);
  controller.showTime(0.25);
  QCOMPARE(told.count(), 1);
  QVERIFY(controller.isPlaying());
  controller.passTime(0.05);
  QCOMPARE(controller.time(), 0.3);
}

void GoingBackTest::aStoppedRunGoesOnAtAnEarlierMoment() {
  RunController controller(ticking(0));
  controller.setScene(lightBallInThickAir());
  playUntil(controller, 2);
  QCOMPARE(controller.run(0).status(), core::RunStatus::kDiverged);
  const double end = controller.run(0).time();
  const Bits last = tests::fingerprint(controller.run(0));
  QSignalSpy changed(&controller, &RunController::runStatusChanged);
  controller.showTime(end / 2);
  QCOMPARE(controller.run(0).status(), core::RunStatus::kRunning);
  QCOMPARE(changed.count(), 1);
  controller.showTime(2);
  QCOMPARE(controller.run(0).status(), core::RunStatus::kDiverged);
  QVERIFY(tests::fingerprint(controller.run(0)) == last);
  QCOMPARE(controller.run(0).time(), end);
  QCOMPARE(changed.count(), 2);
}

void GoingBackTest::stoppedRunsDoNotHoldUpTheWayAhead() {
  auto scene = lightBallInThickAir();
  scene->solvers.push_back({.method = "euler", .step = 0.04});
  double perLook = 0;
  RunController controller([&perLook, now = 0.0]() mutable { return now += perLook; });
  controller.setPatience(INFINITY);  // which would look at the clock, too
  controller.setScene(scene);
  playUntil(controller, 2);
  QVERIFY(controller.run(0).time() < 2 && controller.run(2).time() < 2);
  controller.showTime(0);
  perLook = 1;  // one step a call
  std::vector<double> moments;
  connect(&controller, &RunController::timeShown, this,
          [&](double time) { moments.push_back(time); });
  controller.showTime(2);
  while (controller.isTravelling()) controller.passTime(0.016);
  for (const double moment : moments) QCOMPARE(moment, 2.0);
  QCOMPARE(controller.run(0).status(), core::RunStatus::kDiverged);
  QCOMPARE(controller.run(2).status(), core::RunStatus::kDiverged);
}

void GoingBackTest::longWaysGoOnInLaterFrames() {
  double perLook = 0;
  RunController controller([&perLook, now = 0.0]() mutable { return now += perLook; });
  controller.setPatience(INFINITY);  // which would look at the clock, too
  controller.setScene(fourRuns());
  playUntil(controller, 2);
  const Bits before = shown(controller);
  QSignalSpy busy(&controller, &RunController::busyChanged);
  QSignalSpy told(&controller, &RunController::timeShown);
  perLook = 1;  // one step a call
  controller.goTo(40);
  QVERIFY(controller.isTravelling());
  QCOMPARE(busy.count(), 1);
  double progress = controller.travelProgress();
  QVERIFY(progress < 0.1);
  for (int i = 0; i < 30; ++i) controller.passTime(0.016);
  QVERIFY(controller.travelProgress() > progress);
  QVERIFY(controller.time() > 2 && controller.time() < 40);
  controller.stopTravelling();
  QVERIFY(!controller.isTravelling());
  QCOMPARE(told.last().first().toDouble(), controller.time());
  QCOMPARE(busy.count(), 2);
  // What it had come to is recorded and the same as ever.
  perLook = 0;
  controller.showTime(2);
  QVERIFY(shown(controller) == before);
}

void GoingBackTest::aGoalThatMovesOnIsFollowed() {
  double perLook = 0;
  RunController controller([&perLook, now = 0.0]() mutable { return now += perLook; });
  controller.setPatience(INFINITY);  // which would look at the clock, too
  // So many weights that states are kept far apart.
  auto scene = std::make_shared<core::Scene>();
  for (int i = 0; i < 9000; ++i) {
    core::Weight weight;
    weight.radius = 1e-3;
    const int row = i / 300;
    weight.position = {0.01 + 0.013 * (i % 300), 0.5 + 0.013 * row};
    scene->weights.push_back(weight);
  }
  scene->solvers = {{.method = "euler", .step = 1e-3}};
  controller.setScene(scene);
  controller.goTo(0.2);
  QVERIFY(controller.recording(0).keptStepBefore(200) < 199);
  perLook = 1;  // one step a call
  std::vector<double> moments;
  connect(&controller, &RunController::timeShown, this,
          [&](double time) { moments.push_back(time); });
  for (int i = 0; i < 60; ++i) controller.showTime(0.18 - 0.002 * i);
  QVERIFY(moments.size() > 5);
  while (controller.isTravelling()) controller.passTime(0.016);
  QCOMPARE(controller.time(), 0.18 - 0.002 * 59);
}

void GoingBackTest::computesOnToALaterMoment() {
  RunController straight(ticking(0)), skipping(ticking(0.001));
  for (RunController* controller : {&straight, &skipping}) controller->setScene(fourRuns());
  playUntil(straight, 3);
  playUntil(skipping, 0.2);
  skipping.showTime(0.1);
  skipping.goTo(3);
  for (int i = 0; skipping.isTravelling(); ++i) {
    QVERIFY(i < 1000);
    skipping.passTime(0.016);
  }
  QCOMPARE(skipping.time(), 3.0);
  QVERIFY(everything(skipping) == everything(straight));
}

void GoingBackTest::goesToTheNextWantedEvent() {
  RunController controller(ticking(0));
  controller.setScene(fourRuns());
  controller.cutAll();
  std::vector<double> found;
  for (int i = 0; i < 5; ++i) {
    controller.goToNext(0, isImpact, controller.time() + 60);
    found.push_back(controller.time());
  }
  std::vector<double> impacts = tests::timesOf(controller.recording(0), isImpact);
  impacts.resize(5);
  QCOMPARE(found, impacts);
  // The same from the record, and backwards.
  controller.showTime(0);
  for (int i = 0; i < 5; ++i) {
    controller.goToNext(0, isImpact, 60);
    QCOMPARE(controller.time(), impacts[i]);
  }
  for (int i = 3; i >= 0; --i) {
    controller.goToPrevious(0, isImpact);
    QCOMPARE(controller.time(), impacts[i]);
  }
}

void GoingBackTest::isPastAnEventAtTheMomentShown() {
  RunController controller(ticking(0));
  auto scene = fourRuns();
  scene->solvers.resize(2);  // of one step, so that both are cut at once
  controller.setScene(scene);
  playUntil(controller, 0.5);
  controller.stepOnce();
  controller.cutAll();
  const double cut = controller.time();
  const auto isCut = [](const core::Event& event) { return event.kind == core::EventKind::kCut; };
  controller.goToNext(0, isCut, 1);
  QCOMPARE(controller.time(), 1.0);
  controller.goToPrevious(0, isCut);
  QCOMPARE(controller.time(), cut);
}

void GoingBackTest::saysWhenThereIsNoSuchEvent() {
  RunController controller(ticking(0));
  controller.setScene(fourRuns());
  QSignalSpy nothing(&controller, &RunController::nothingFound);
  controller.goToNext(
      0, [](const core::Event& event) { return event.time > 50; }, 2);
  QCOMPARE(controller.time(), 2.0);
  QCOMPARE(nothing.count(), 1);
  QCOMPARE(nothing.first(), (QVariantList{0.0, 2.0}));
  controller.goToPrevious(0, [](const core::Event&) { return false; });
  QCOMPARE(controller.time(), 2.0);
  QCOMPARE(nothing.last(), (QVariantList{0.0, 2.0}));
}

QTEST_GUILESS_MAIN(GoingBackTest)
#include "going_back_test.moc"
