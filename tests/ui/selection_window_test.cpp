#include <QDockWidget>
#include <QLocale>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include "core/scene/arrangement.h"
#include "ui/control/scene_editor.h"
#include "ui/control/selection.h"
#include "ui/main_window.h"
#include "ui/panels/charts_panel.h"
#include "ui/panels/events_panel.h"

using ui::MainWindow;

namespace {

core::Scene threeWeights() {
  core::Scene scene = core::withWeightCount(core::Scene(), 3);
  for (core::Weight& weight : scene.weights) weight.rope->angle = 0.5;
  scene.solvers = {{.method = "rk4"}};
  return scene;
}

QSpinBox* chooser(const MainWindow& window, const QString& name) {
  for (auto* box : window.findChildren<QSpinBox*>())
    if (box->accessibleName() == name) return box;
  qFatal("no chooser named %s", qPrintable(name));
}

void enter(QSpinBox* box, const QString& text) {
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, text);
  QTest::keyClick(box, Qt::Key_Return);
}

}  // namespace

/// The selected weight in the panels of the window.
class SelectionWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void panelsFollowTheSelection();
  void aNumberTypedIntoTheFormSelects();
  void aNumberTypedForTheStepSelects();
  void panelsAreNotForcedBack();
  void panelsIgnoreAWeightThatIsInNoRun();

 private:
  QTemporaryDir m_folder;
};

void SelectionWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void SelectionWindowTest::panelsFollowTheSelection() {
  MainWindow window(threeWeights());
  window.selection()->select(1);
  QCOMPARE(chooser(window, "Weight")->value(), 2);
  QCOMPARE(chooser(window, "Weight whose step is shown")->value(), 2);
  QCOMPARE(chooser(window, "Weight in the chart")->text(), QString("Weight 2"));
  QCOMPARE(chooser(window, "Weight whose events are listed")->text(), QString("Weight 2"));
  window.selection()->clear();
  QCOMPARE(chooser(window, "Weight")->text(), QString("All"));
  QCOMPARE(chooser(window, "Weight whose step is shown")->value(), 2);
  QCOMPARE(chooser(window, "Weight in the chart")->text(), QString("All weights"));
  QCOMPARE(chooser(window, "Weight whose events are listed")->text(), QString("All weights"));
}

void SelectionWindowTest::aNumberTypedIntoTheFormSelects() {
  MainWindow window(threeWeights());
  window.show();
  window.findChild<QDockWidget*>("weights")->raise();
  enter(chooser(window, "Weight"), "3");
  QCOMPARE(window.selection()->weight(), 2);
  QCOMPARE(window.charts()->weight(), 2);
  enter(chooser(window, "Weight"), "0");
  QCOMPARE(window.selection()->weight(), std::nullopt);
  QCOMPARE(window.charts()->weight(), -1);
}

void SelectionWindowTest::aNumberTypedForTheStepSelects() {
  MainWindow window(threeWeights());
  window.show();
  window.findChild<QDockWidget*>("step")->raise();
  enter(chooser(window, "Weight whose step is shown"), "2");
  QCOMPARE(window.selection()->weight(), 1);
  QCOMPARE(chooser(window, "Weight")->value(), 2);
}

void SelectionWindowTest::panelsAreNotForcedBack() {
  MainWindow window(threeWeights());
  window.selection()->select(1);
  auto* events = window.findChild<ui::EventsPanel*>();
  events->setWeight(-1);  // as its chooser does
  window.charts()->chooseWeight(2);
  window.editor()->change([](core::Scene& scene) { scene.gravity = 5; });
  QCOMPARE(events->weight(), -1);
  QCOMPARE(window.charts()->weight(), 2);
  window.selection()->clear();
  QCOMPARE(window.charts()->weight(), 2);
  window.selection()->select(0);
  QCOMPARE(events->weight(), 0);
  QCOMPARE(window.charts()->weight(), 0);
}

void SelectionWindowTest::panelsIgnoreAWeightThatIsInNoRun() {
  MainWindow window(threeWeights());
  // On top of the last one: it stays a draft.
  window.editor()->change(
      [](core::Scene& scene) { scene.weights.push_back(scene.weights.back()); });
  window.selection()->select(3);
  QCOMPARE(chooser(window, "Weight")->value(), 4);
  QCOMPARE(window.charts()->weight(), -1);
  QCOMPARE(window.findChild<ui::EventsPanel*>()->weight(), -1);
}

QTEST_MAIN(SelectionWindowTest)
#include "selection_window_test.moc"
