#include "ui/panels/step_panel.h"

#include <memory>
#include <numbers>

#include <QComboBox>
#include <QLocale>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include "core/trade/reference.h"
#include "ui/control/run_controller.h"
#include "ui/panels/comparison_panel.h"
#include "ui/panels/step_table.h"

using ui::RunController;
using ui::StepPanel;
using ui::StepTable;

namespace {

/// A weight let go at 30° without air under g = 10 m/s², and one that flies, in two runs.
std::shared_ptr<const core::Scene> handScene() {
  core::Scene scene;
  scene.gravity = 10;
  scene.airDensity = 0;
  core::Weight hanging;
  hanging.rope = core::Rope{.pivot = {1, 2.5}, .length = 1, .angle = std::numbers::pi / 6};
  core::Weight flying;
  flying.position = {3, 1};
  scene.weights = {hanging, flying};
  scene.solvers = {{.method = "rk4", .step = 0.1}, {.method = "euler", .step = 0.1}};
  return std::make_shared<const core::Scene>(scene);
}

QString cell(const QTableWidget& table, const QString& row, int column) {
  for (int i = 0; i < table.rowCount(); ++i)
    if (table.verticalHeaderItem(i)->text() == row) return table.item(i, column)->text();
  return "no row " + row;
}

template <class Widget>
Widget* named(QWidget* parent, const QString& name) {
  for (Widget* widget : parent->findChildren<Widget*>())
    if (widget->accessibleName() == name) return widget;
  qFatal("nothing named %s", qPrintable(name));
}

}  // namespace

/// The panels that open up a step and that compare runs.
class StepPanelTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void init();
  void showsAStepWorkedByHandInNumbers();
  void followsTheSteppingControls();
  void followsTheChosenWeight();
  void showsTheRunThatIsChosen();
  void opensTheStepInTheSceneWhileItIsSeen();
  void comparesRunsInFigures();
  void measuresFromAReferenceThatIsAdded();

 private:
  std::unique_ptr<RunController> m_controller;
  std::unique_ptr<StepPanel> m_panel;
  StepTable* m_table = nullptr;
};

void StepPanelTest::init() {
  m_controller = std::make_unique<RunController>([] { return 0.0; });
  m_panel = std::make_unique<StepPanel>(m_controller.get());
  m_panel->choosers()->setParent(m_panel.get());
  m_table = m_panel->findChild<StepTable*>();
  m_controller->setScene(handScene());
  m_panel->resize(1000, 300);
  m_panel->show();
}

void StepPanelTest::showsAStepWorkedByHandInNumbers() {
  m_controller->stepOnce();
  QTRY_COMPARE(cell(*m_table, "Start", 1), QString("30.00000"));
  // tests/core/run/step_stages_test works this step out: k1 is −5/s², in degrees −286.4789,
  // k3 is −4.8913590/s², and the end is 0.024818932 below 30° with −0.49274453/s.
  QCOMPARE(cell(*m_table, "k1", 0), QString("1/6"));
  QCOMPARE(cell(*m_table, "k2", 0), QString("2/6"));
  QCOMPARE(cell(*m_table, "k1", 2), QString("−286.4789"));
  QCOMPARE(cell(*m_table, "k3", 2), QString("−280.2542"));
  QCOMPARE(cell(*m_table, "End, Runge–Kutta 4", 1), QString("28.57798"));
  QCOMPARE(cell(*m_table, "End, Runge–Kutta 4", 2), QString("−28.23218"));
  // Euler leaves the angle as it is.
  QCOMPARE(cell(*m_table, "End, Euler (explicit)", 1), QString("30.00000"));
  // 30° − 5 t²/2 + 43.30 t⁴/24, the fourth derivative being 10 cos 30° · 5, is 30° − 0.0248196
  // at 0.1 s; the term with t⁶ is zero.
  QCOMPARE(cell(*m_table, "End, exact", 1), QString("28.57794"));
}

void StepPanelTest::followsTheSteppingControls() {
  QTRY_COMPARE(m_table->rowCount(), 9);  // at the start, the step to come
  QCOMPARE(cell(*m_table, "Start", 1), QString("30.00000"));
  m_controller->stepOnce();
  m_controller->stepOnce();
  QTRY_COMPARE(cell(*m_table, "Start", 1), QString("28.57798"));
  m_controller->reset();
  QTRY_COMPARE(cell(*m_table, "Start", 1), QString("30.00000"));
}

void StepPanelTest::followsTheChosenWeight() {
  QSignalSpy chosen(m_panel.get(), &StepPanel::weightChosen);
  m_panel->chooseWeight(2);
  QCOMPARE(chosen.size(), 1);
  m_panel->chooseWeight(0);  // all weights: it stays
  QCOMPARE(chosen.size(), 1);
  // Falling free, g h = 1 m/s after the step.
  QTRY_COMPARE(m_table->columnCount(), 6);
  QVERIFY(m_table->horizontalHeaderItem(1)->text().startsWith("x in m"));
  QCOMPARE(cell(*m_table, "End, Runge–Kutta 4", 4), QString("−1.000000"));
  QCOMPARE(cell(*m_table, "End, Euler (explicit)", 5), QString("0.0500"));
}

void StepPanelTest::showsTheRunThatIsChosen() {
  named<QComboBox>(m_panel.get(), "Run whose step is shown")->setCurrentIndex(1);
  QTRY_COMPARE(m_table->rowCount(), 6);  // one slope
  QCOMPARE(cell(*m_table, "k1", 0), QString("1"));
}

void StepPanelTest::opensTheStepInTheSceneWhileItIsSeen() {
  std::optional<ui::ShownStep> opened;
  connect(m_panel.get(), &StepPanel::stepOpened, this, [&](const ui::ShownStep* step, std::size_t) {
    opened.reset();
    if (step) opened = *step;
  });
  m_controller->stepOnce();
  QTRY_VERIFY(opened.has_value());
  QCOMPARE(opened->slopes.size(), std::size_t{4});
  QCOMPARE(opened->end, m_controller->run(0).weight(0).position);
  // The second slope: −0.25 m/s along (cos 30°, sin 30°), for 0.1 s.
  const Eigen::Vector2d way = -0.025 * Eigen::Vector2d(std::sqrt(3) / 2, 0.5);
  QVERIFY((opened->slopes[1].way - way).norm() < 1e-12);
  m_panel->setSeen(false);  // behind another tab
  QVERIFY(!opened);
  m_panel->setSeen(true);
  QVERIFY(opened.has_value());
  m_panel->hide();
  QVERIFY(!opened);
}

void StepPanelTest::comparesRunsInFigures() {
  ui::ComparisonPanel panel(m_controller.get());
  m_controller->setScene(handScene());
  panel.resize(1000, 300);
  panel.show();
  const auto* table = panel.findChild<QTableWidget*>();
  m_controller->stepOnce();
  // Euler falls not at all in its first step, where the other falls g h²/2 = 0.05 m.
  QTRY_COMPARE(table->item(1, 1)->text(), QString("0.0500"));
  QCOMPARE(table->item(0, 1)->text(), QString("–"));
  // So it has m g · 0.05 m = 0.095 J too much in the fall; and m (g h)²/2 of it is right.
  // The swing, without its fall, has m L² ω²/2 = 0.19 · 0.25/2 = 0.02375 J too much.
  const double drift = 0.19 * 10 * 0.05 + 0.02375;
  QVERIFY(std::abs(table->item(1, 2)->text().toDouble() - drift) < 5e-4);
  QCOMPARE(table->item(1, 4)->text(), QString::number(m_controller->run(1).slopeEvaluations()));
}

void StepPanelTest::measuresFromAReferenceThatIsAdded() {
  ui::ComparisonPanel panel(m_controller.get());
  panel.chooser()->setParent(&panel);
  m_controller->setScene(handScene());
  auto* chooser = named<QComboBox>(&panel, "Run that distances are measured from");
  QCOMPARE(chooser->currentIndex(), 0);
  core::Scene scene = *handScene();
  scene.solvers.push_back(core::referenceSolver(0.1));
  m_controller->setScene(std::make_shared<const core::Scene>(scene));
  QCOMPARE(chooser->currentIndex(), 2);
  QVERIFY(chooser->currentText().contains("Reference"));
}

QTEST_MAIN(StepPanelTest)
#include "step_panel_test.moc"
