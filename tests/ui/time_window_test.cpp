// Drives the window as a person does who goes back and forth in time.
#include <cmath>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QStatusBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "core/scene/arrangement.h"
#include "tests/support/fingerprint.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/main_window.h"
#include "ui/panels/events_panel.h"
#include "ui/panels/timeline.h"
#include "ui/panels/travel_bar.h"

using core::EventKind;
using ui::Command;
using ui::MainWindow;

namespace {

/// Three weights that swing, are cut at 1.5 s, fall and bounce.
core::Scene cutScene() {
  core::Scene scene = core::withWeightCount(core::Scene(), 3);
  for (core::Weight& weight : scene.weights) weight.rope->angle = 0.3;
  scene.cutTime = 1.5;
  scene.solvers = {{.method = "rk4"}, {.method = "euler"}};
  return scene;
}

bool isImpact(const core::Event& event) {
  return event.kind >= EventKind::kImpactFloor && event.kind <= EventKind::kImpactWeight;
}

/// Times of the first run's events that are wanted, each moment once.
template <class Wanted>
std::vector<double> timesOf(const MainWindow& window, const Wanted& wanted) {
  std::vector<double> times;
  for (const core::Event& event : window.controller()->recording(0).eventLog().events()) {
    if (wanted(event) && (times.empty() || event.time > times.back())) times.push_back(event.time);
  }
  return times;
}

/// A window in front, whose work takes no time.
class Window : public MainWindow {
 public:
  Window() : MainWindow(cutScene()) {
    controller()->setStopwatch([] { return 0.0; });
    show();
    if (!QTest::qWaitForWindowActive(this)) qFatal("the window is not active");
  }

  double time() const { return controller()->time(); }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(this, key, modifiers);
  }
  void showEvents() {
    findChild<QDockWidget*>("events")->raise();
    QApplication::processEvents();
  }
  QTableView* list() const { return findChild<ui::EventsPanel*>()->findChild<QTableView*>(); }
  QString text(int row, int column) const {
    return list()->model()->index(row, column).data().toString();
  }
  void clickRow(int row) const {
    const QModelIndex index = list()->model()->index(row, 0);
    list()->scrollTo(index);
    QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, list()->visualRect(index).center());
  }
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
  void listFollowsTheMomentShown();
  void clickOnAnEventShowsItsMoment();
  void arrowKeysInTheListGoFromEventToEvent();
  void listHasRoomForItsHeadings();
  void listsOneWeightOrKind();
  void listsTheEventsOfTheChosenRun();
  void copiesEventsAsCsv();
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
  const std::vector<double> times = timesOf(window, [kind](const core::Event& event) {
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
  const std::vector<double> impacts = timesOf(window, isImpact);
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
  straight.setScene(std::make_shared<core::Scene>(cutScene()));
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

void TimeWindowTest::listFollowsTheMomentShown() {
  Window window;
  window.controller()->goTo(3);
  window.showEvents();
  const auto events = window.controller()->recording(0).eventLog().events();
  QCOMPARE(window.list()->model()->rowCount(), static_cast<int>(events.size()));
  for (const double time : {1.1, 0.2, 1.9}) {
    window.controller()->showTime(time);
    const auto later = std::ranges::upper_bound(events, time, {}, &core::Event::time);
    const int row = static_cast<int>(later - events.begin()) - 1;
    QCOMPARE(window.list()->currentIndex().row(), row);
    if (row >= 0)
      QVERIFY(window.list()->viewport()->rect().intersects(
          window.list()->visualRect(window.list()->currentIndex())));
    // Following does not lead away from the moment.
    QCOMPARE(window.time(), time);
  }
}

void TimeWindowTest::clickOnAnEventShowsItsMoment() {
  Window window;
  window.controller()->goTo(3);
  window.showEvents();
  window.controller()->play();
  const auto events = window.controller()->recording(0).eventLog().events();
  for (const int row : {static_cast<int>(events.size()) - 1, 0}) {
    window.clickRow(row);
    QCOMPARE(window.time(), events[row].time);
    QCOMPARE(window.list()->currentIndex().row(), row);
    QVERIFY(!window.controller()->isPlaying());
  }
}

void TimeWindowTest::arrowKeysInTheListGoFromEventToEvent() {
  Window window;
  window.controller()->goTo(3);
  window.showEvents();
  window.clickRow(0);
  const auto events = window.controller()->recording(0).eventLog().events();
  for (int row = 1; row < 4; ++row) {
    QTest::keyClick(window.list(), Qt::Key_Down);
    QCOMPARE(window.time(), events[row].time);
    QCOMPARE(window.list()->currentIndex().row(), row);
  }
}

void TimeWindowTest::listHasRoomForItsHeadings() {
  Window window;
  window.showEvents();
  const QHeaderView* columns = window.list()->horizontalHeader();
  QVERIFY(columns->font().pointSizeF() >= 12);
  for (int column = 0; column < columns->count(); ++column)
    QVERIFY2(columns->sectionSize(column) >= columns->sectionSizeHint(column),
             qPrintable(QStringLiteral("%1: %2 < %3")
                            .arg(column)
                            .arg(columns->sectionSize(column))
                            .arg(columns->sectionSizeHint(column))));
}

void TimeWindowTest::listsOneWeightOrKind() {
  Window window;
  window.controller()->goTo(3);
  window.showEvents();
  auto* weight = window.findChild<QSpinBox*>("eventWeight");
  QCOMPARE(weight->maximum(), 3);
  weight->setFocus();
  weight->selectAll();
  QTest::keyClicks(weight, "2");
  QTest::keyClick(weight, Qt::Key_Return);
  const int count = window.list()->model()->rowCount();
  const auto all = window.controller()->recording(0).eventLog().events().size();
  QVERIFY(count > 0 && count < static_cast<int>(all));
  for (int row = 0; row < count; ++row) {
    const QString who = window.text(row, 2);
    QVERIFY2(who.contains('2') || who == "all", qPrintable(who));
  }
  window.findChild<ui::EventsPanel*>()->setWeight(-1);
  auto* kinds = window.findChild<QComboBox*>("eventKinds");
  kinds->setFocus();
  QTest::keyClicks(kinds, "Cuts");
  QCOMPARE(window.list()->model()->rowCount(), 1);
  QCOMPARE(window.text(0, 1), QString("Cut"));
}

void TimeWindowTest::listsTheEventsOfTheChosenRun() {
  Window window;
  window.controller()->goTo(3);
  window.showEvents();
  auto* runs = window.findChild<QComboBox*>("eventRun");
  runs->setFocus();
  QTest::keyClick(runs, Qt::Key_Down);
  const auto events = window.controller()->recording(1).eventLog().events();
  QCOMPARE(window.list()->model()->rowCount(), static_cast<int>(events.size()));
  // And the keys go by it.
  window.controller()->showTime(1.6);
  window.press(Qt::Key_I);
  const auto next = std::ranges::find_if(
      events, [](const core::Event& event) { return event.time > 1.6 && isImpact(event); });
  QCOMPARE(window.time(), next->time);
}

void TimeWindowTest::copiesEventsAsCsv() {
  Window window;
  window.controller()->goTo(3);
  window.showEvents();
  window.clickRow(0);
  QTest::keyClick(window.list(), Qt::Key_Down, Qt::ShiftModifier);
  QTest::keyClick(window.list(), Qt::Key_C, Qt::ControlModifier);
  QStringList lines = QApplication::clipboard()->text().split("\r\n");
  QCOMPARE(lines.size(), 4);  // header, two events, end
  QVERIFY(lines[0].startsWith("time,event,weight"));
  // Not the ropes: C alone cuts them.
  window.clickRow(0);
  QTest::keyClick(window.list(), Qt::Key_C, Qt::ControlModifier);
  lines = QApplication::clipboard()->text().split("\r\n");
  QCOMPARE(lines.size(), window.list()->model()->rowCount() + 2);
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
  window.controller()->setStopwatch([now = 0.0]() mutable { return now += 1; });
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
