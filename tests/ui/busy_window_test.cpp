#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include "core/scene/arrangement.h"
#include "tests/support/endless_step.h"
#include "tests/support/swinging_scene.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/main_window.h"
#include "ui/panels/comparison_panel.h"
#include "ui/panels/travel_bar.h"
#include "ui/view/scene_area.h"

using tests::swingingScene;
using ui::MainWindow;

namespace {}  // namespace

/// A window whose runs take longer than it may wait for.
class BusyWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void answersToKeysDuringAStepWithoutEnd();
  void tellsHowFarTheStepIsAndHowSlowItGoes();
  void closesDuringAStepWithoutEnd();
  void panelsBehindATabRest();
  void saysWhatBecomesOfTrails();

 private:
  static void show(MainWindow& window) {
    window.resize(1280, 720);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
  }

  /// Presses Space, and lets the window's own clock begin the step.
  static void playIntoTheStep(MainWindow& window) {
    window.controller()->setPatience(0);
    QTest::keyClick(&window, Qt::Key_Space);
    QTRY_VERIFY(window.controller()->isStepUnderWay());
  }

  QTemporaryDir m_folder;  // for settings
};

void BusyWindowTest::initTestCase() {
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void BusyWindowTest::answersToKeysDuringAStepWithoutEnd() {
  MainWindow window(*tests::endlessStep());
  show(window);
  ui::RunController* controller = window.controller();
  playIntoTheStep(window);
  const QAction* trails = window.commands().action(ui::Command::kTrails);
  const bool shown = trails->isChecked();
  QTest::keyClick(&window, Qt::Key_T);
  QCOMPARE(trails->isChecked(), !shown);
  QVERIFY(controller->isStepUnderWay());
  QTest::keyClick(&window, Qt::Key_Space);
  QVERIFY(!controller->isPlaying());
  QVERIFY(!controller->isStepUnderWay());
  playIntoTheStep(window);
  QTest::keyClick(&window, Qt::Key_Escape);
  QVERIFY(!controller->isPlaying());
  playIntoTheStep(window);
  QTest::keyClick(&window, Qt::Key_R);
  QVERIFY(!controller->isStepUnderWay());
  playIntoTheStep(window);
  core::Scene other = swingingScene();
  window.editor()->replace(other);
  QVERIFY(!controller->isStepUnderWay());
  QCOMPARE(controller->run(0).weightCount(), 3);
}

void BusyWindowTest::tellsHowFarTheStepIsAndHowSlowItGoes() {
  MainWindow window(*tests::endlessStep());
  show(window);
  const auto* bar = window.findChild<ui::TravelBar*>();
  const auto* pace = window.findChild<QLabel*>("pace");
  playIntoTheStep(window);
  QVERIFY(!bar->isVisible());
  QCOMPARE(pace->text(), "in real time");
  for (int frame = 0; frame < 300; ++frame) window.controller()->passTime(1.0 / 60);
  QVERIFY(bar->isVisible());
  QVERIFY(bar->findChild<QLabel*>()->text().startsWith("Computing one step for 5"));
  QCOMPARE(pace->text(), "0.2× real time");
  QTest::mouseClick(bar->findChild<QPushButton*>(), Qt::LeftButton);
  QVERIFY(!window.controller()->isPlaying());
  QVERIFY(!bar->isVisible());
}

void BusyWindowTest::closesDuringAStepWithoutEnd() {
  auto window = std::make_unique<MainWindow>(*tests::endlessStep());
  show(*window);
  playIntoTheStep(*window);
  QVERIFY(window->close());
  window.reset();
}

void BusyWindowTest::panelsBehindATabRest() {
  MainWindow window(swingingScene());
  show(window);
  window.controller()->setStopwatch([] { return 0.0; });
  auto* panel = window.findChild<ui::ComparisonPanel*>();
  auto* dock = window.findChild<QDockWidget*>("comparison");
  const auto* table = panel->findChild<QTableWidget*>();
  const auto slopes = [table] { return table->item(0, table->columnCount() - 1)->text(); };
  QVERIFY(!panel->isVisible());
  const QString before = slopes();
  window.controller()->goTo(1);
  QTest::qWait(0);
  QCOMPARE(slopes(), before);
  dock->raise();
  QTRY_VERIFY(panel->isVisible());
  QVERIFY(slopes() != before);
}

void BusyWindowTest::saysWhatBecomesOfTrails() {
  const auto words = [](const MainWindow& window) {
    return window.findChild<QLabel*>("painter")->text();
  };
  MainWindow few(swingingScene(3));
  QVERIFY(!words(few).contains("rails"));
  MainWindow many(swingingScene(200));
  QVERIFY(words(many).startsWith("Trails shortened: many weights · "));
  many.findChild<ui::SceneArea*>()->setTrailsShown(false);
  QVERIFY(!words(many).contains("rails"));
  MainWindow veryMany(swingingScene(2000));
  QVERIFY(words(veryMany).startsWith("No trails: too many weights · "));
}

QTEST_MAIN(BusyWindowTest)
#include "busy_window_test.moc"
