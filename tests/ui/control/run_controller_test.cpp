#include "ui/control/run_controller.h"

#include <cmath>

#include <QSignalSpy>
#include <QTest>

#include "core/scene/arrangement.h"
#include "tests/support/controlled_runs.h"

using tests::lightBallInThickAir;
using tests::ticking;
using ui::RunController;

namespace {

/// Three weights that hang and swing, under RK4 and Euler.
std::shared_ptr<core::Scene> swingingScene(double firstStep = 1.0 / 60,
                                           double secondStep = 1.0 / 60) {
  core::Scene scene = core::withWeightCount(core::Scene(), 3);
  for (core::Weight& weight : scene.weights) weight.rope->angle = 0.5;
  scene.solvers = {{.method = "rk4", .step = firstStep}, {.method = "euler", .step = secondStep}};
  return std::make_shared<core::Scene>(scene);
}

bool isInsideLatestStep(const core::Run& run, double time) {
  const double step = run.solver().step;
  return run.time() - step <= time && time <= run.time();
}

double cutTime(const core::Recording& recording) {
  for (const core::Event& event : recording.eventLog().events()) {
    if (event.kind == core::EventKind::kCut) return event.time;
  }
  return NAN;
}

}  // namespace

class RunControllerTest : public QObject {
  Q_OBJECT

 private slots:
  void showsTheMomentThatIsDue_data();
  void showsTheMomentThatIsDue();
  void standsStillWhilePaused();
  void tellsOncePerFrame();
  void shownMomentLiesInTheLatestStepOfEveryRun();
  void frameTimesDoNotChangeTheRuns();
  void stepsToTheEndsOfTheFirstRunsSteps();
  void finishesAStepThatPlayingLeftHalfShown();
  void stepsByFramesAtTheSpeedInForce();
  void cutsAllRunsAtOneMoment();
  void cutsOnceTheSlowerRunsAreThere();
  void cannotCutTwice();
  void fallsBehindInsteadOfFreezing();
  void computesHalfTheTimeWhereDrawingIsSlow();
  void stopsADivergedRunWhileTheOthersGoOn();
  void pausesWhenNoRunCanGoOn();
  void startsAgainOnReset();
  void goesOnPlayingInAChangedScene();
};

void RunControllerTest::showsTheMomentThatIsDue_data() {
  QTest::addColumn<double>("speed");
  QTest::newRow("slowest") << 1.0 / 16;
  QTest::newRow("real time") << 1.0;
  QTest::newRow("fastest") << 4.0;
}

void RunControllerTest::showsTheMomentThatIsDue() {
  QFETCH(double, speed);
  RunController controller(ticking(0));
  controller.setScene(swingingScene());
  controller.setSpeed(speed);
  controller.play();
  for (int frame = 0; frame < 60; ++frame) controller.passTime(1.0 / 60);
  // Sixty sums of frames: as exact as their rounding.
  QVERIFY(std::abs(controller.time() - speed) < 1e-12);
  QCOMPARE(controller.keptShare(), 1.0);
}

void RunControllerTest::standsStillWhilePaused() {
  RunController controller(ticking(0));
  controller.setScene(swingingScene());
  controller.passTime(0.05);
  QCOMPARE(controller.time(), 0.0);
  controller.play();
  controller.passTime(0.05);
  controller.pause();
  controller.passTime(0.05);
  QCOMPARE(controller.time(), 0.05);
}

void RunControllerTest::tellsOncePerFrame() {
  RunController controller(ticking(0));
  controller.setScene(swingingScene(1e-4, 1e-4));
  QSignalSpy shown(&controller, &RunController::timeShown);
  QSignalSpy playing(&controller, &RunController::playingChanged);
  controller.play();
  controller.play();
  controller.passTime(0.05);
  QCOMPARE(shown.count(), 1);
  QCOMPARE(playing.count(), 1);
}

void RunControllerTest::shownMomentLiesInTheLatestStepOfEveryRun() {
  RunController controller(ticking(0.001));
  controller.setScene(swingingScene(1.0 / 7, 1e-3));
  controller.play();
  for (int frame = 0; frame < 100; ++frame) {
    controller.passTime(0.016);
    for (const core::Run* run : controller.runs()) {
      QVERIFY(isInsideLatestStep(*run, controller.time()));
    }
  }
  QVERIFY(controller.time() > 0.5);
}

void RunControllerTest::frameTimesDoNotChangeTheRuns() {
  RunController even(ticking(0));
  RunController uneven(ticking(0.003));
  for (RunController* controller : {&even, &uneven}) {
    controller->setScene(swingingScene());
    controller->play();
  }
  for (int frame = 0; even.run(0).stepCount() < 120; ++frame) even.passTime(0.0125);
  for (int frame = 0; uneven.run(0).stepCount() < 120; ++frame) {
    uneven.passTime(frame % 3 == 0 ? 0.09 : 0.002);
  }
  while (even.run(0).stepCount() < uneven.run(0).stepCount()) even.stepOnce();
  for (int i = 0; i < 3; ++i) {
    const core::WeightState a = even.run(0).weight(i);
    const core::WeightState b = uneven.run(0).weight(i);
    QVERIFY(a.angle == b.angle && a.angularVelocity == b.angularVelocity);
  }
}

void RunControllerTest::stepsToTheEndsOfTheFirstRunsSteps() {
  RunController controller(ticking(0));
  controller.setScene(swingingScene(1.0 / 60, 1.0 / 240));
  for (int step = 1; step <= 5; ++step) {
    controller.stepOnce();
    QCOMPARE(controller.time(), step * (1.0 / 60));
    QCOMPARE(controller.run(0).stepCount(), step);
    QCOMPARE(controller.run(1).stepCount(), 4 * step);
  }
}

void RunControllerTest::finishesAStepThatPlayingLeftHalfShown() {
  RunController controller(ticking(0));
  controller.setScene(swingingScene(0.1, 0.1));
  controller.play();
  controller.passTime(0.05);
  controller.stepOnce();
  QVERIFY(!controller.isPlaying());
  QCOMPARE(controller.time(), 0.1);
  QCOMPARE(controller.run(0).stepCount(), 1);
}

void RunControllerTest::stepsByFramesAtTheSpeedInForce() {
  RunController controller(ticking(0));
  controller.setScene(swingingScene());
  controller.setSpeed(0.25);
  controller.stepFrame();
  QCOMPARE(controller.time(), 0.25 / 60);
}

void RunControllerTest::cutsAllRunsAtOneMoment() {
  RunController controller(ticking(0));
  controller.setScene(swingingScene(1.0 / 60, 1.0 / 240));
  controller.play();
  controller.passTime(0.09);
  QVERIFY(controller.run(0).time() > controller.run(1).time());
  controller.cutAll();
  QVERIFY(!controller.canCut());
  controller.passTime(0.09);
  QCOMPARE(cutTime(controller.recording(0)), 0.1);
  QCOMPARE(cutTime(controller.recording(1)), 0.1);
}

void RunControllerTest::cutsOnceTheSlowerRunsAreThere() {
  RunController controller(ticking(0));
  controller.setScene(swingingScene(0.1, 0.03));
  controller.play();
  controller.passTime(0.05);
  controller.cutAll();
  controller.passTime(0.1);
  QCOMPARE(cutTime(controller.recording(0)), 0.1);
  // The first end of a step of 0.03 s that is not before.
  QCOMPARE(cutTime(controller.recording(1)), 0.12);
}

void RunControllerTest::cannotCutTwice() {
  RunController controller(ticking(0));
  QSignalSpy changed(&controller, &RunController::canCutChanged);
  controller.setScene(swingingScene());
  QVERIFY(controller.canCut());
  controller.cutAll();
  QVERIFY(!controller.canCut());
  controller.cutAll();
  controller.stepOnce();
  QCOMPARE(changed.count(), 2);
  QVERIFY(controller.run(0).allCut());
  QVERIFY(controller.run(1).allCut());
}

void RunControllerTest::fallsBehindInsteadOfFreezing() {
  // Each step takes 5 ms of a budget of 12 ms, so three of 1 ms are taken per frame.
  RunController controller(ticking(0.005));
  controller.setScene(swingingScene(1e-3, 10));
  controller.play();
  for (int frame = 0; frame < 600; ++frame) controller.passTime(0.016);
  QVERIFY(controller.time() < 600 * 0.004);
  QVERIFY(controller.keptShare() < 0.25);
  QVERIFY(controller.keptShare() > 0.1);
}

void RunControllerTest::computesHalfTheTimeWhereDrawingIsSlow() {
  const auto stepsIn = [](double frame) {
    RunController controller(ticking(0.001));
    controller.setPatience(INFINITY);  // which would look at the clock, too
    controller.setScene(swingingScene(1e-4, 10));
    controller.play();
    controller.passTime(frame);
    return controller.run(0).stepCount();
  };
  // A look at the clock a step, of 1 ms; the one of the second run, and one of each for the end.
  QVERIFY(std::abs(stepsIn(0.016) - 12) <= 2);
  QVERIFY(std::abs(stepsIn(0.06) - 30) <= 2);
  QVERIFY(std::abs(stepsIn(10) - 50) <= 2);
}

void RunControllerTest::stopsADivergedRunWhileTheOthersGoOn() {
  RunController controller(ticking(0));
  controller.setScene(lightBallInThickAir());
  QSignalSpy stopped(&controller, &RunController::runStatusChanged);
  controller.play();
  for (int frame = 0; frame < 60; ++frame) controller.passTime(0.05);
  QCOMPARE(stopped.count(), 1);
  QCOMPARE(controller.run(0).status(), core::RunStatus::kDiverged);
  QVERIFY(controller.run(0).weight(0).position.allFinite());
  QCOMPARE(controller.run(1).status(), core::RunStatus::kRunning);
  QVERIFY(controller.isPlaying());
  QVERIFY(std::abs(controller.time() - 3) < 1e-9);
}

void RunControllerTest::pausesWhenNoRunCanGoOn() {
  auto scene = lightBallInThickAir();
  scene->solvers.pop_back();
  RunController controller(ticking(0));
  controller.setScene(scene);
  controller.play();
  for (int frame = 0; frame < 60; ++frame) controller.passTime(0.05);
  QVERIFY(!controller.isPlaying());
  QVERIFY(!controller.canGoOn());
  const double stop = controller.time();
  QCOMPARE(stop, controller.run(0).time());
  controller.play();
  QVERIFY(!controller.isPlaying());
  controller.stepOnce();
  controller.stepFrame();
  QCOMPARE(controller.time(), stop);
}

void RunControllerTest::startsAgainOnReset() {
  RunController controller(ticking(0));
  controller.setScene(swingingScene());
  QSignalSpy restarted(&controller, &RunController::restarted);
  controller.play();
  controller.passTime(0.05);
  controller.cutAll();
  controller.reset();
  QVERIFY(!controller.isPlaying());
  QCOMPARE(restarted.count(), 1);
  QCOMPARE(controller.time(), 0.0);
  QCOMPARE(controller.run(0).weight(0).angle, 0.5);
  QVERIFY(controller.canCut());
}

void RunControllerTest::goesOnPlayingInAChangedScene() {
  RunController controller(ticking(0));
  controller.setScene(swingingScene());
  controller.play();
  controller.passTime(0.05);
  controller.setScene(swingingScene(1.0 / 120));
  QVERIFY(controller.isPlaying());
  QCOMPARE(controller.time(), 0.0);
}

QTEST_MAIN(RunControllerTest)
#include "run_controller_test.moc"
