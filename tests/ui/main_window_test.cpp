#include "ui/main_window.h"

#include <cmath>

#include <QAction>
#include <QApplication>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QImageReader>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include "core/scene/arrangement.h"
#include "tests/support/controlled_runs.h"
#include "tests/support/fields.h"
#include "tests/support/shown_window.h"
#include "tests/support/swinging_scene.h"
#include "ui/control/commands.h"
#include "ui/control/exports.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/files/scene_file.h"
#include "ui/panels/message_bar.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/step_table.h"
#include "ui/panels/weights_form.h"
#include "ui/style/theme.h"
#include "ui/view/scene_view.h"

using tests::enter;
using tests::fieldNamed;
using tests::showInFront;
using tests::swingingScene;
using ui::Command;
using ui::MainWindow;

namespace {

/// Lets this much time pass, whatever the clock on the wall says.
void pass(MainWindow& window, double seconds) {
  // Nor does it matter how long the work for it takes.
  window.controller()->setStopwatch([] { return 0.0; });
  window.controller()->passTime(seconds);
}

QString messages(const MainWindow& window) {
  QString all;
  for (const ui::MessageBar* bar : window.findChildren<ui::MessageBar*>()) {
    if (bar->isVisibleTo(&window)) all += bar->message();
  }
  return all;
}

}  // namespace

class MainWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void playsAndPausesWithTheSpaceBar();
  void stepsWithTheArrowKeys();
  void cutsAndResetsByKey();
  void splitsTheViewByKey();
  void opensUpTheStepOfTheWeightInTheForm();
  void changesTheSpeedByKey();
  void playsByButton();
  void showsTheTimeInDigits();
  void aChangedFieldRestartsTheScene();
  void aBadValueIsMarkedAndTheSceneGoesOn();
  void aSceneThatCannotRunIsNotTakenAndCanBeUndone();
  void keysReachTheWindowAfterAValueWasEntered();
  void saysWhichMethodDivergedAndWhen();
  void offersOnlyWhatCanBeDone();
  void followsAChangeOfColors();
  void everyCommandIsInAMenu();

 private:
  QTemporaryDir m_folder;
};

void MainWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void MainWindowTest::playsAndPausesWithTheSpaceBar() {
  MainWindow window(swingingScene());
  showInFront(window);
  QVERIFY(!window.controller()->isPlaying());
  QTest::keyClick(&window, Qt::Key_Space);
  QVERIFY(window.controller()->isPlaying());
  pass(window, 0.1);
  QVERIFY(window.controller()->time() >= 0.1);
  QTest::keyClick(&window, Qt::Key_Space);
  QVERIFY(!window.controller()->isPlaying());
}

void MainWindowTest::stepsWithTheArrowKeys() {
  core::Scene scene = swingingScene();
  scene.solvers[0].step = 1.0 / 240;
  MainWindow window(scene);
  showInFront(window);
  QTest::keyClick(&window, Qt::Key_Right);
  QCOMPARE(window.controller()->time(), 1.0 / 240);
  QTest::keyClick(&window, Qt::Key_Right, Qt::ShiftModifier);
  QCOMPARE(window.controller()->time(), 1.0 / 240 + 1.0 / 60);
}

void MainWindowTest::cutsAndResetsByKey() {
  MainWindow window(swingingScene());
  showInFront(window);
  QTest::keyClick(&window, Qt::Key_C);
  QVERIFY(!window.commands().action(Command::kCut)->isEnabled());
  QTest::keyClick(&window, Qt::Key_Right);
  QVERIFY(window.controller()->run(0).allCut());
  QVERIFY(window.controller()->run(1).allCut());
  QTest::keyClick(&window, Qt::Key_R);
  QCOMPARE(window.controller()->time(), 0.0);
  QVERIFY(!window.controller()->run(0).allCut());
  QVERIFY(window.commands().action(Command::kCut)->isEnabled());
}

void MainWindowTest::splitsTheViewByKey() {
  MainWindow window(swingingScene());
  showInFront(window);
  const auto views = [&] { return window.findChildren<ui::SceneView*>().size(); };
  QCOMPARE(views(), 1);
  QTest::keyClick(&window, Qt::Key_V);
  QCOMPARE(views(), 2);
  window.editor()->change([](core::Scene& draft) { draft.solvers.pop_back(); });
  QCOMPARE(views(), 1);
  QVERIFY(!window.commands().action(Command::kSplit)->isEnabled());
}

void MainWindowTest::opensUpTheStepOfTheWeightInTheForm() {
  MainWindow window(swingingScene());
  showInFront(window);
  window.findChild<QDockWidget*>("step")->raise();
  window.findChild<ui::WeightsForm*>()->choose(3);
  QTest::keyClick(&window, Qt::Key_Right);
  const auto* table = window.findChild<ui::StepTable*>();
  const double angle = window.controller()->run(0).weight(2).angle * 180 / std::acos(-1);
  const auto endShown = [&] {
    for (int i = 0; i < table->rowCount(); ++i)
      if (table->verticalHeaderItem(i)->text() == "End, Runge–Kutta 4")
        return table->item(i, 1)->text();
    return QString();
  };
  QTRY_COMPARE(endShown(), QString::number(angle, 'f', 5));
}

void MainWindowTest::changesTheSpeedByKey() {
  MainWindow window(swingingScene());
  showInFront(window);
  for (int i = 0; i < 3; ++i) QTest::keyClick(&window, Qt::Key_Period);
  QCOMPARE(window.controller()->speed(), 4.0);
  for (int i = 0; i < 10; ++i) QTest::keyClick(&window, Qt::Key_Comma);
  QCOMPARE(window.controller()->speed(), 1.0 / 64);
}

void MainWindowTest::playsByButton() {
  MainWindow window(swingingScene());
  showInFront(window);
  for (QToolButton* button : window.findChildren<QToolButton*>()) {
    if (button->defaultAction() != window.commands().action(Command::kPlay)) continue;
    if (!button->isVisible()) continue;  // of the presentation
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(button->text(), QString("Pause"));
  }
  QVERIFY(window.controller()->isPlaying());
}

void MainWindowTest::showsTheTimeInDigits() {
  MainWindow window(swingingScene());
  window.controller()->play();
  pass(window, 0.075);
  QStringList texts;
  for (const QLabel* label : window.findChildren<QLabel*>()) texts << label->text();
  QVERIFY(texts.contains("0.075 s"));
}

void MainWindowTest::aChangedFieldRestartsTheScene() {
  MainWindow window(swingingScene());
  showInFront(window);
  window.controller()->play();
  pass(window, 0.1);
  enter(fieldNamed(window, "Gravity"), "1.62");
  QCOMPARE(window.controller()->time(), 0.0);
  QCOMPARE(window.controller()->scene().gravity, 1.62);
  QVERIFY(window.controller()->isPlaying());
  QVERIFY(window.isWindowModified());
}

void MainWindowTest::aBadValueIsMarkedAndTheSceneGoesOn() {
  MainWindow window(swingingScene());
  showInFront(window);
  window.controller()->play();
  pass(window, 0.1);
  enter(fieldNamed(window, "Gravity"), "-1");
  QCOMPARE(fieldNamed(window, "Gravity")->reason(), QString("Must be from 0 to 1000\u00a0m/s²"));
  QVERIFY(window.controller()->time() >= 0.1);
  QCOMPARE(window.controller()->scene().gravity, 9.81);
  QVERIFY(!window.isWindowModified());
}

void MainWindowTest::aSceneThatCannotRunIsNotTakenAndCanBeUndone() {
  MainWindow window(swingingScene());
  showInFront(window);
  window.controller()->play();
  pass(window, 0.1);
  enter(fieldNamed(window, "Width"), "0.5");
  QVERIFY(messages(window).contains("outside the room"));
  QVERIFY(window.controller()->time() >= 0.1);
  for (ui::MessageBar* bar : window.findChildren<ui::MessageBar*>()) {
    if (bar->isVisible()) QTest::mouseClick(bar->findChild<QToolButton*>(), Qt::LeftButton);
  }
  QCOMPARE(messages(window), QString());
  QCOMPARE(fieldNamed(window, "Width")->spinBox()->text(), QString("4 m"));
}

void MainWindowTest::keysReachTheWindowAfterAValueWasEntered() {
  MainWindow window(swingingScene());
  showInFront(window);
  enter(fieldNamed(window, "Gravity"), "5");
  QWidget* focus = window.focusWidget() ? window.focusWidget() : &window;
  QTest::keyClick(focus, Qt::Key_C);
  QVERIFY(!window.controller()->canCut());
  QTest::keyClick(focus, Qt::Key_Space);
  QVERIFY(window.controller()->isPlaying());
}

void MainWindowTest::saysWhichMethodDivergedAndWhen() {
  MainWindow window(*tests::lightBallInThickAir());
  window.controller()->play();
  for (int frame = 0; frame < 30; ++frame) pass(window, 0.05);
  const core::Run& euler = window.controller()->run(0);
  QCOMPARE(euler.status(), core::RunStatus::kDiverged);
  QVERIFY(messages(window).startsWith("Euler"));
  QVERIFY(messages(window).contains(QString("diverged at %1 s").arg(euler.time(), 0, 'f', 3)));
  QVERIFY(window.controller()->isPlaying());
  window.controller()->reset();
  QCOMPARE(messages(window), QString());
}

void MainWindowTest::offersOnlyWhatCanBeDone() {
  core::Scene scene = *tests::lightBallInThickAir();
  scene.solvers.pop_back();
  MainWindow window(scene);
  const auto isOffered = [&](Command command) {
    return window.commands().action(command)->isEnabled();
  };
  QVERIFY(!isOffered(Command::kCut));  // no ropes
  QVERIFY(isOffered(Command::kPlay));
  window.controller()->play();
  for (int frame = 0; frame < 30; ++frame) pass(window, 0.05);
  QVERIFY(!isOffered(Command::kPlay));
  QVERIFY(!isOffered(Command::kStep));
  window.controller()->reset();
  QVERIFY(isOffered(Command::kPlay));
}

void MainWindowTest::followsAChangeOfColors() {
  MainWindow window(swingingScene());
  showInFront(window);
  const auto choose = [&](const QString& words) {
    for (QAction* action : window.findChildren<QAction*>()) {
      if (action->text().remove('&') == words) action->trigger();
    }
  };
  choose("Dark");
  QTRY_VERIFY(ui::Theme::of(window.palette()).dark);
  QVERIFY(MainWindow(swingingScene()).palette().color(QPalette::Window).lightness() < 128);
  choose("Light");
  QTRY_VERIFY(!ui::Theme::of(window.palette()).dark);
}

void MainWindowTest::everyCommandIsInAMenu() {
  MainWindow window(swingingScene());
  for (const QAction* action : window.commands().all()) {
    bool inMenu = false;
    for (const QObject* object : action->associatedObjects()) {
      inMenu |= object->inherits("QMenu");
    }
    QVERIFY2(inMenu, qPrintable(action->text()));
  }
}

QTEST_MAIN(MainWindowTest)
#include "main_window_test.moc"
