#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLocale>
#include <QSettings>
#include <QSpinBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/scene/arrangement.h"
#include "tests/support/fields.h"
#include "tests/support/shown_window.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/main_window.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/runs_form.h"
#include "ui/panels/weights_form.h"

using tests::enter;
using tests::fieldNamed;
using tests::showInFront;
using ui::Command;
using ui::MainWindow;

namespace {

core::Scene threeWeights() {
  core::Scene scene = core::withWeightCount(core::Scene(), 3);
  scene.name = "Three & more";
  scene.solvers = {{.method = "rk4"}, {.method = "euler"}};
  return scene;
}

/// Types where the keyboard's focus is, as a person does.
void press(MainWindow& window, Qt::Key key, Qt::KeyboardModifiers modifiers) {
  QTest::keyClick(window.focusWidget() ? window.focusWidget() : &window, key, modifiers);
}

void undo(MainWindow& window) {
  press(window, Qt::Key_Z, Qt::ControlModifier);
}

void redo(MainWindow& window) {
  press(window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
}

}  // namespace

class UndoWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void offersToUndoByItsWords();
  void undoesFieldsByKey();
  void oneGoOfAnArrowIsOneStep();
  void undoesATypedTextBeforeTheScene();
  void aFieldThatOnlyChoosesLeavesUndoToTheWindow();
  void undoesChangesOfRunsAndOfTheCut();
  void undoesADraftThatCannotRun();
  void undoesToWhatIsSaved();
  void undoesAStartOfANewScene();

 private:
  QTemporaryDir m_folder;
};

void UndoWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void UndoWindowTest::offersToUndoByItsWords() {
  MainWindow window(threeWeights());
  showInFront(window);
  const QAction* undoAction = window.commands().action(Command::kUndo);
  const QAction* redoAction = window.commands().action(Command::kRedo);
  QVERIFY(!undoAction->isEnabled());
  enter(fieldNamed(window, "Length"), "0.8");
  QVERIFY(undoAction->isEnabled());
  QCOMPARE(undoAction->text(), QString("&Undo change of length"));
  undo(window);
  QCOMPARE(window.statusBar()->currentMessage(), QString("Undone: change of length"));
  QCOMPARE(undoAction->text(), QString("&Undo"));
  QCOMPARE(redoAction->text(), QString("&Redo change of length"));
  redo(window);
  QCOMPARE(window.editor()->scene()->weights[2].rope->length, 0.8);
  window.editor()->setSaved();
}

void UndoWindowTest::undoesFieldsByKey() {
  MainWindow window(threeWeights());
  showInFront(window);
  const core::Scene before = *window.editor()->scene();
  for (const char* name : {"Gravity", "Air density", "Width", "Restitution of walls",
                           "Friction of walls", "Start angle", "Mass", "Radius"})
    enter(fieldNamed(window, name), "0.3");
  enter(fieldNamed(window, "Weights"), "2");
  QVERIFY(window.isWindowModified());
  int steps = 0;
  for (; window.editor()->canUndo(); ++steps) undo(window);
  QCOMPARE(steps, 9);
  QVERIFY(window.controller()->scene() == before);
  QVERIFY(!window.isWindowModified());
  QCOMPARE(fieldNamed(window, "Gravity")->spinBox()->text(), QString("9.81 m/s²"));
}

void UndoWindowTest::oneGoOfAnArrowIsOneStep() {
  MainWindow window(threeWeights());
  showInFront(window);
  ui::QuantitySpinBox* gravity = fieldNamed(window, "Gravity")->spinBox();
  gravity->setFocus();
  for (int i = 0; i < 5; ++i) QTest::keyClick(gravity, Qt::Key_Up);
  QCOMPARE(window.editor()->scene()->gravity, 10.3);
  undo(window);  // the field has the keyboard still
  QCOMPARE(window.editor()->scene()->gravity, 9.81);
  QVERIFY(!window.editor()->canUndo());
  // Two goes, with something else between them or not, are two steps.
  QTest::keyClick(gravity, Qt::Key_Up);
  QTest::keyClick(gravity, Qt::Key_Return);
  gravity->setFocus();
  QTest::keyClick(gravity, Qt::Key_Up);
  undo(window);
  QCOMPARE(window.editor()->scene()->gravity, 9.9);
  window.editor()->setSaved();
}

void UndoWindowTest::undoesATypedTextBeforeTheScene() {
  MainWindow window(threeWeights());
  showInFront(window);
  enter(fieldNamed(window, "Gravity"), "5");
  ui::QuantitySpinBox* width = fieldNamed(window, "Width")->spinBox();
  width->setFocus();
  width->selectAll();
  QTest::keyClicks(width, "7");
  undo(window);
  QCOMPARE(width->text(), QString("4 m"));
  QCOMPARE(window.editor()->scene()->gravity, 5.0);
  undo(window);
  QCOMPARE(window.editor()->scene()->gravity, 9.81);
}

void UndoWindowTest::aFieldThatOnlyChoosesLeavesUndoToTheWindow() {
  MainWindow window(threeWeights());
  showInFront(window);
  enter(fieldNamed(window, "Gravity"), "5");
  window.findChild<QDockWidget*>("weights")->raise();
  auto* chooser = window.findChild<ui::WeightsForm*>()->findChild<QSpinBox*>();
  chooser->setFocus();
  QTRY_VERIFY(chooser->hasFocus());
  QTest::keyClick(chooser, Qt::Key_Up);
  undo(window);
  QCOMPARE(window.editor()->scene()->gravity, 9.81);
  QCOMPARE(chooser->value(), 1);
}

void UndoWindowTest::undoesChangesOfRunsAndOfTheCut() {
  MainWindow window(threeWeights());
  showInFront(window);
  const core::Scene before = *window.editor()->scene();
  const auto* runs = window.findChild<ui::RunsForm*>();
  runs->findChildren<QCheckBox*>().at(1)->click();
  QTest::keyClick(runs->findChildren<QComboBox*>().at(0), Qt::Key_End);
  enter(fieldNamed(*runs, "Tolerance of run 1"), "1e-6");
  for (QCheckBox* box : window.findChildren<QCheckBox*>())
    if (box->text() == "Cut at") box->click();
  QVERIFY(window.editor()->scene()->cutTime.has_value());
  QCOMPARE(window.controller()->runCount(), 1);
  for (int i = 0; i < 4; ++i) undo(window);
  QVERIFY(window.controller()->scene() == before);
  QCOMPARE(window.controller()->runCount(), 2);
  QVERIFY(!window.editor()->canUndo());
}

void UndoWindowTest::undoesADraftThatCannotRun() {
  MainWindow window(threeWeights());
  showInFront(window);
  enter(fieldNamed(window, "Width"), "0.5");
  QVERIFY(fieldNamed(window, "Width")->isMarked());
  undo(window);
  QVERIFY(!fieldNamed(window, "Width")->isMarked());
  QCOMPARE(fieldNamed(window, "Width")->spinBox()->text(), QString("4 m"));
  QVERIFY(window.editor()->problems().empty());
  QVERIFY(!window.isWindowModified());
}

void UndoWindowTest::undoesToWhatIsSaved() {
  MainWindow window(threeWeights());
  showInFront(window);
  enter(fieldNamed(window, "Gravity"), "5");
  QVERIFY(window.files()->saveTo(m_folder.filePath("saved.json")));
  enter(fieldNamed(window, "Gravity"), "6");
  QVERIFY(window.isWindowModified());
  undo(window);
  QVERIFY(!window.isWindowModified());
  undo(window);
  QVERIFY(window.isWindowModified());
  window.editor()->setSaved();
}

void UndoWindowTest::undoesAStartOfANewScene() {
  const QString file = m_folder.filePath("three.json");
  MainWindow window(threeWeights(), file);
  showInFront(window);
  press(window, Qt::Key_N, Qt::ControlModifier);
  QCOMPARE(window.controller()->scene().weights.size(), std::size_t{1});
  QVERIFY(window.windowTitle().startsWith("New scene"));
  undo(window);
  QCOMPARE(window.controller()->scene().weights.size(), std::size_t{3});
  QVERIFY(window.windowTitle().startsWith("three.json"));
  QCOMPARE(window.files()->file(), file);
  QVERIFY(!window.isWindowModified());
}

QTEST_MAIN(UndoWindowTest)
#include "undo_window_test.moc"
