// Drives the window as a person does who goes back and forth in time.
#include <cmath>

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QInputDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "tests/support/controlled_runs.h"
#include "tests/support/fingerprint.h"
#include "tests/support/impacts.h"
#include "tests/support/shown_window.h"
#include "tests/support/swinging_scene.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/main_window.h"
#include "ui/panels/timeline.h"
#include "ui/panels/travel_bar.h"

using core::EventKind;
using tests::isImpact;
using ui::Command;

namespace {

class Window : public tests::ShownWindow {
 public:
  Window() : ShownWindow(tests::cutSwings()) {}
};

}  // namespace

class TimeWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void stepsBothWaysWithTheArrowKeys();
  void goesFromEventToEventByKey_data();
  void goesFromEventToEventByKey();
  void computesOnToTheFirstImpact();
  void saysWhenThereIsNothingToGoTo();
  void goesToStartAndEndByKey();
  void playsTheRecordAgainAndGoesOn();
  void cutsAtAPastMoment();
  void goesToATypedTime();
  void offersOnlyWhatCanBeDone();
  void scrubsOnTheTimeline();
  void slowMotionShowsMomentsInsideSteps();
  void longComputingShowsProgressAndStops_data();
  void longComputingShowsProgressAndStops();
  void everyKeyMeansOneThing();

 private:
  QTemporaryDir m_folder;
};

void TimeWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void TimeWindowTest::stepsBothWaysWithTheArrowKeys() {
  Window window;
  for (int i = 0; i < 5; ++i) window.press(Qt::Key_Right);
  QCOMPARE(window.time(), 5 * (1.0 / 60));
  const std::vector<double> there = tests::fingerprint(window.controller()->run(1));
  window.press(Qt::Key_Left);
  window.press(Qt::Key_Left);
  QCOMPARE(window.time(), 3 * (1.0 / 60));
  window.press(Qt::Key_Right);
  window.press(Qt::Key_Right);
  QVERIFY(tests::fingerprint(window.controller()->run(1)) == there);
  window.controller()->setSpeed(0.25);
  window.press(Qt::Key_Left, Qt::ShiftModifier);
  QCOMPARE(window.time(), 5 * (1.0 / 60) - 0.25 / 60);
  window.press(Qt::Key_Right, Qt::ShiftModifier);
  QCOMPARE(window.time(), 5 * (1.0 / 60));
}

void TimeWindowTest::goesFromEventToEventByKey_data() {
  QTest::addColumn<Qt::Key>("key");
  QTest::addColumn<Qt::KeyboardModifiers>("forward");
  QTest::addColumn<Qt::Key>("backKey");
  QTest::addColumn<Qt::KeyboardModifiers>("back");
  QTest::addColumn<int>("kind");  // −1: any, −2: impacts
  const Qt::KeyboardModifiers none;
  QTest::newRow("any") << Qt::Key_Right << Qt::KeyboardModifiers(Qt::ControlModifier)
                       << Qt::Key_Left << Qt::KeyboardModifiers(Qt::ControlModifier) << -1;
  const auto letter = [&](const char* name, Qt::Key key, int kind) {
    QTest::newRow(name) << key << none << key << Qt::KeyboardModifiers(Qt::ShiftModifier) << kind;
  };
  letter("impacts", Qt::Key_I, -2);
  letter("turning points", Qt::Key_U, static_cast<int>(EventKind::kTurningPoint));
  letter("cuts", Qt::Key_X, static_cast<int>(EventKind::kCut));
}

void TimeWindowTest::goesFromEventToEventByKey() {
  QFETCH(Qt::Key, key);
  QFETCH(Qt::KeyboardModifiers, forward);
  QFETCH(Qt::Key, backKey);
  QFETCH(Qt::KeyboardModifiers, back);
  QFETCH(int, kind);
  Window window;
  window.controller()->goTo(3);
  const std::vector<double> times =
      tests::timesOf(window.controller()->recording(0), [kind](const core::Event& event) {
        return kind == -1 || (kind == -2 ? isImpact(event) : static_cast<int>(event.kind) == kind);
      });
  QVERIFY(!times.empty());
  window.press(Qt::Key_Home);
  for (const double time : times) {
    if (time == 0) continue;
    window.press(key, forward);
    QCOMPARE(window.time(), time);
  }
  for (auto time = times.rbegin() + 1; time != times.rend(); ++time) {
    window.press(backKey, back);
    QCOMPARE(window.time(), *time);
  }
}

void TimeWindowTest::computesOnToTheFirstImpact() {
  Window window;
  window.press(Qt::Key_I);
  const std::vector<double> impacts = tests::timesOf(window.controller()->recording(0), isImpact);
  QCOMPARE(window.time(), impacts.front());
  QVERIFY(window.time() > 1.5);
}

void TimeWindowTest::saysWhenThereIsNothingToGoTo() {
  Window window;
  window.press(Qt::Key_Right);
  window.press(Qt::Key_I, Qt::ShiftModifier);
  QCOMPARE(window.statusBar()->currentMessage(),
           QString("Impacts: none between 0.000 s and 0.017 s."));
  QCOMPARE(window.time(), 1.0 / 60);
}

void TimeWindowTest::goesToStartAndEndByKey() {
  Window window;
  window.controller()->goTo(1.5);
  const double end = window.controller()->recordedUntil();
  window.press(Qt::Key_Home);
  QCOMPARE(window.time(), 0.0);
  window.press(Qt::Key_End);
  QCOMPARE(window.time(), end);
}

void TimeWindowTest::playsTheRecordAgainAndGoesOn() {
  ui::RunController straight([] { return 0.0; });
  straight.setScene(std::make_shared<core::Scene>(tests::cutSwings()));
  straight.goTo(2);
  Window window;
  window.controller()->goTo(1.5);
  window.press(Qt::Key_Home);
  QCOMPARE(window.time(), 0.0);
  window.press(Qt::Key_Space);
  QVERIFY(window.controller()->isPlaying());
  while (window.time() < 1.99) window.controller()->passTime(0.05);
  window.controller()->pause();
  window.controller()->goTo(2);
  for (int i = 0; i < 2; ++i)
    QVERIFY(tests::fingerprint(window.controller()->run(i)) == tests::fingerprint(straight.run(i)));
}

void TimeWindowTest::cutsAtAPastMoment() {
  Window window;
  window.controller()->goTo(2);
  QVERIFY(!window.commands().action(Command::kCut)->isEnabled());
  window.controller()->showTime(0.5);
  QVERIFY(window.commands().action(Command::kCut)->isEnabled());
  window.press(Qt::Key_C);
  QCOMPARE(window.controller()->recordedUntil(), 0.5);
  QVERIFY(window.controller()->run(0).allCut());
  window.press(Qt::Key_End);
  QCOMPARE(window.time(), 0.5);
}

void TimeWindowTest::goesToATypedTime() {
  Window window;
  QTimer::singleShot(0, this, [] {
    auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
    QVERIFY(dialog);
    auto* field = dialog->findChild<QDoubleSpinBox*>();
    field->selectAll();
    QTest::keyClicks(field, "1.25");
    QTest::keyClick(field, Qt::Key_Return);
  });
  window.press(Qt::Key_G, Qt::ControlModifier);
  QCOMPARE(window.time(), 1.25);
}

void TimeWindowTest::offersOnlyWhatCanBeDone() {
  Window window;
  const auto isOffered = [&](Command command) {
    return window.commands().action(command)->isEnabled();
  };
  QVERIFY(!isOffered(Command::kStepBack));
  QVERIFY(!isOffered(Command::kPreviousImpact));
  QVERIFY(!isOffered(Command::kGoToEnd));
  QVERIFY(!isOffered(Command::kStopTravelling));
  window.press(Qt::Key_Right);
  QVERIFY(isOffered(Command::kStepBack));
  QVERIFY(!isOffered(Command::kGoToEnd));
  window.press(Qt::Key_Left);
  QVERIFY(!isOffered(Command::kStepBack));
  QVERIFY(isOffered(Command::kGoToEnd));
}

void TimeWindowTest::scrubsOnTheTimeline() {
  Window window;
  window.controller()->goTo(2);
  auto* timeline = window.findChild<ui::Timeline*>();
  const auto at = [&](double time) {
    return QPoint(static_cast<int>(timeline->positionOf(time)), timeline->height() / 2);
  };
  const double pixel = 1 / (timeline->positionOf(1) - timeline->positionOf(0));
  QTest::mousePress(timeline, Qt::LeftButton, {}, at(1.7));
  for (const double time : {0.4, 1.3, 0.2}) {
    QTest::mouseMove(timeline, at(time));
    QVERIFY(std::abs(window.time() - time) <= pixel);
    QStringList labels;
    for (const QLabel* label : window.findChildren<QLabel*>()) labels << label->text();
    QVERIFY(labels.contains(QString("%1 s").arg(window.time(), 0, 'f', 3)));
  }
  QTest::mouseRelease(timeline, Qt::LeftButton, {}, at(0.2));
}

void TimeWindowTest::slowMotionShowsMomentsInsideSteps() {
  Window window;
  for (int i = 0; i < 6; ++i) window.press(Qt::Key_Comma);
  QCOMPARE(window.controller()->speed(), 1.0 / 64);
  window.controller()->play();
  Eigen::Vector2d before = window.controller()->run(0).weight(0).position;
  for (int frame = 1; frame < 64; ++frame) {
    window.controller()->passTime(1.0 / 60);
    QVERIFY(std::abs(window.time() - frame / 3840.0) < 1e-12);
    // Each frame a little further, while the run has taken but one step.
    const core::Run& run = window.controller()->run(0);
    const Eigen::Vector2d now = run.weightAt(0, window.time()).position;
    QVERIFY(now != before);
    before = now;
    QCOMPARE(run.stepCount(), 1);
  }
}

void TimeWindowTest::longComputingShowsProgressAndStops_data() {
  QTest::addColumn<bool>("byKey");
  QTest::newRow("Escape") << true;
  QTest::newRow("button") << false;
}

void TimeWindowTest::longComputingShowsProgressAndStops() {
  QFETCH(bool, byKey);
  Window window;
  auto* bar = window.findChild<ui::TravelBar*>();
  // Each look at the clock takes a second: one step of one run between two frames.
  window.controller()->setStopwatch(tests::ticking(1));
  window.controller()->goTo(100);
  QVERIFY(!bar->isVisible());
  QTRY_VERIFY(bar->isVisible());
  QTRY_VERIFY(window.time() > 0.1);
  QVERIFY(window.time() < 100);
  if (byKey) {
    window.press(Qt::Key_Escape);
  } else {
    QTest::mouseClick(bar->findChild<QPushButton*>(), Qt::LeftButton);
  }
  QVERIFY(!window.controller()->isTravelling());
  QVERIFY(!bar->isVisible());
  const double stopped = window.time();
  QTest::qWait(50);
  QCOMPARE(window.time(), stopped);
}

void TimeWindowTest::everyKeyMeansOneThing() {
  const Window window;
  QSet<QKeySequence> seen;
  for (const QAction* action : window.commands().all()) {
    // Esc leaves what is under way; see tools_window_test.
    if (action == window.commands().action(Command::kDeselect)) continue;
    for (const QKeySequence& keys : action->shortcuts()) {
      QVERIFY2(!seen.contains(keys), qPrintable(keys.toString()));
      seen << keys;
    }
  }
  QVERIFY(seen.size() > 20);
}

QTEST_MAIN(TimeWindowTest)
#include "time_window_test.moc"
