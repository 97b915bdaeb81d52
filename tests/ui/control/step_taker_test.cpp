#include "ui/control/step_taker.h"

#include <memory>
#include <vector>

#include <QCoreApplication>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/controlled_runs.h"
#include "tests/support/endless_step.h"
#include "tests/support/fingerprint.h"
#include "tests/support/heap.h"
#include "tests/support/random_scene.h"
#include "ui/control/run_controller.h"

using tests::lightBallInThickAir;
using tests::ticking;
using ui::RunController;

namespace {

using Bits = std::vector<double>;

/// Six made-up weights under three methods with different steps.
std::shared_ptr<core::Scene> threeRuns() {
  auto scene = std::make_shared<core::Scene>(tests::randomScene(1, 6));
  scene->cutTime.reset();
  scene->solvers = {{.method = "rk4", .step = 1.0 / 60},
                    {.method = "euler", .step = 1.0 / 45},
                    {.method = "dopri5", .step = 0.007}};
  return scene;
}

std::shared_ptr<core::Scene> heap(int count = 20) {
  auto scene = std::make_shared<core::Scene>(*tests::pouredHeap(count, 0.5));
  scene->solvers = {{.method = "rk4", .step = 1.0 / 60}, {.method = "euler", .step = 1.0 / 60}};
  return scene;
}

/// How the runs stand, and all that is recorded.
Bits everything(const RunController& controller) {
  Bits bits{controller.time()};
  const Bits recorded = tests::recordedBits(controller);
  bits.insert(bits.end(), recorded.begin(), recorded.end());
  for (const core::Run* run : controller.runs()) {
    for (int i = 0; i < run->weightCount(); ++i) {
      const core::WeightState weight = run->weightAt(i, controller.time());
      bits.insert(bits.end(), {weight.position.x(), weight.position.y()});
    }
  }
  for (int i = 1; i < controller.runCount(); ++i)
    for (const core::Separation& apart :
         controller.separations().between(0, static_cast<std::size_t>(i)).samples())
      bits.insert(bits.end(), {apart.time, apart.distance});
  return bits;
}

/// Until nothing is under way any more.
void finish(RunController& controller) {
  while (controller.isStepUnderWay() || controller.isTravelling()) {
    QCoreApplication::processEvents();
    controller.passTime(0);
  }
}

void playUntil(RunController& controller, double time) {
  controller.play();
  while (controller.isPlaying() && controller.time() < time) {
    controller.passTime(std::min(1.0 / 60, time - controller.time()));
    finish(controller);
  }
  controller.pause();
}

/// Plays, cuts, goes back, steps, and plays on.
Bits lesson(const std::shared_ptr<core::Scene>& scene, double patience) {
  RunController controller(ticking(0));
  controller.setPatience(patience);
  controller.setScene(scene);
  // At moments inside the steps of all runs, for they are reached to within rounding.
  playUntil(controller, 0.1104);
  controller.cutAll();
  playUntil(controller, 0.3104);
  const auto after = [&](auto&& act) {
    act();
    finish(controller);
  };
  after([&] { controller.showTime(0.083); });
  Bits bits = everything(controller);
  after([&] { controller.stepOnce(); });
  after([&] { controller.stepBack(); });
  after([&] { controller.goTo(0.4104); });
  playUntil(controller, 0.5104);
  after([&] { controller.showTime(0.5103); });
  const Bits end = everything(controller);
  bits.insert(bits.end(), end.begin(), end.end());
  return bits;
}

}  // namespace

class StepTakerTest : public QObject {
  Q_OBJECT

 private slots:
  void takesTheSameStepsInTheOtherThread_data();
  void takesTheSameStepsInTheOtherThread();
  void givesUpAStepThatTakesLong();
  void handlesEventsWhileAStepIsUnderWay();
  void pausesAtOnce();
  void startsAnotherSceneAtOnce();
  void cutsAtOnce();
  void goesBackAtOnce();
  void endsWhileAStepIsUnderWay();
  void takesQuickStepsAtOnceAgain();
};

void StepTakerTest::takesTheSameStepsInTheOtherThread_data() {
  QTest::addColumn<std::shared_ptr<core::Scene>>("scene");
  QTest::newRow("events") << threeRuns();
  QTest::newRow("a run that stops") << lightBallInThickAir();
  QTest::newRow("heap") << heap();
}

void StepTakerTest::takesTheSameStepsInTheOtherThread() {
  QFETCH(std::shared_ptr<core::Scene>, scene);
  const Bits here = lesson(scene, 1);
  QVERIFY(here.size() > 100);
  QCOMPARE(lesson(scene, 0), here);
}

void StepTakerTest::givesUpAStepThatTakesLong() {
  // Every look at this clock takes a hundredth of a second: the fourth is one too many.
  RunController controller([now = 0.0]() mutable { return now += 0.01; });
  controller.setScene(tests::endlessStep());
  controller.play();
  controller.passTime(1.0 / 60);
  QVERIFY(controller.isStepUnderWay());
  QCOMPARE(controller.time(), 0.0);
}

void StepTakerTest::handlesEventsWhileAStepIsUnderWay() {
  RunController controller(ticking(0));
  controller.setPatience(0);
  controller.setScene(tests::endlessStep());
  QSignalSpy frames(&controller, &RunController::framePassed);
  controller.play();
  controller.passTime(1.0 / 60);
  int handled = 0;
  for (int i = 0; i < 1000; ++i) {
    QMetaObject::invokeMethod(
        this, [&handled] { ++handled; }, Qt::QueuedConnection);
    QCoreApplication::processEvents();
    controller.passTime(1.0 / 60);
    QVERIFY(controller.isStepUnderWay());
  }
  QCOMPARE(handled, 1000);
  QCOMPARE(frames.count(), 1001);
  QCOMPARE(controller.time(), 0.0);
  // Nothing came of 1001 frames: a mean over one second of them, by rounding.
  QVERIFY(std::abs(controller.waited() - 1001.0 / 60) < 1e-9);
  QVERIFY(std::abs(controller.keptShare() - 60.0 / 1001) < 1e-9);
}

void StepTakerTest::pausesAtOnce() {
  RunController controller(ticking(0));
  controller.setPatience(0);
  controller.setScene(tests::endlessStep());
  controller.play();
  controller.passTime(1.0 / 60);
  controller.pause();
  QVERIFY(!controller.isStepUnderWay());
  QVERIFY(!controller.isPlaying());
  // And plays on once the other thread has noticed.
  controller.play();
  QTRY_VERIFY((controller.passTime(1.0 / 60), controller.isStepUnderWay()));
}

void StepTakerTest::startsAnotherSceneAtOnce() {
  RunController controller(ticking(0));
  controller.setPatience(0);
  controller.setScene(tests::endlessStep());
  controller.play();
  controller.passTime(1.0 / 60);
  controller.setScene(threeRuns());
  QVERIFY(!controller.isStepUnderWay());
  QCOMPARE(controller.runCount(), 3);
  QTRY_VERIFY((controller.passTime(1.0 / 60), controller.time() > 0.1));
  controller.reset();
  QCOMPARE(controller.time(), 0.0);
  QVERIFY(!controller.isStepUnderWay());
}

void StepTakerTest::cutsAtOnce() {
  auto scene = tests::endlessStep();
  scene->weights[0].rope = core::Rope{.pivot = scene->weights[0].position, .length = 0.02};
  RunController controller(ticking(0));
  controller.setPatience(0);
  controller.setScene(scene);
  controller.play();
  controller.passTime(1.0 / 60);
  QVERIFY(controller.canCut());
  controller.cutAll();
  QVERIFY(controller.run(0).allCut());
  QVERIFY(!controller.isStepUnderWay());
}

void StepTakerTest::goesBackAtOnce() {
  RunController controller(ticking(0));
  controller.setScene(heap());
  playUntil(controller, 0.5);
  controller.showTime(0.5);
  const Bits before = everything(controller);
  controller.setPatience(0);
  controller.play();
  controller.passTime(1.0 / 60);
  QVERIFY(controller.isStepUnderWay());
  controller.goTo(0.2);
  finish(controller);
  QCOMPARE(controller.time(), 0.2);
  controller.goTo(0.5);
  finish(controller);
  QCOMPARE(everything(controller), before);
}

void StepTakerTest::endsWhileAStepIsUnderWay() {
  auto controller = std::make_unique<RunController>(ticking(0));
  controller->setPatience(0);
  controller->setScene(tests::endlessStep());
  controller->play();
  controller->passTime(1.0 / 60);
  QVERIFY(controller->isStepUnderWay());
  controller.reset();
}

void StepTakerTest::takesQuickStepsAtOnceAgain() {
  // One look too many at this clock, and none of its looks takes any time after that.
  RunController controller([now = 0.0]() mutable { return now < 1 ? now += 0.5 : now; });
  controller.setScene(heap(100));
  controller.play();
  controller.passTime(1.0 / 60);
  QVERIFY(controller.isStepUnderWay());
  finish(controller);
  for (int frame = 0; frame < 10; ++frame) {
    controller.passTime(1.0 / 60);
    finish(controller);
  }
  const double before = controller.time();
  controller.passTime(1.0 / 60);
  QVERIFY(!controller.isStepUnderWay());
  QVERIFY(controller.time() > before);
}

QTEST_GUILESS_MAIN(StepTakerTest)
#include "step_taker_test.moc"
