#include <cmath>
#include <numbers>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/scene/arrangement.h"
#include "core/scene/scene_limits.h"
#include "tests/support/shown_window.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/selection.h"
#include "ui/main_window.h"
#include "ui/panels/message_bar.h"
#include "ui/panels/weight_columns.h"
#include "ui/panels/weights_form.h"
#include "ui/panels/weights_table.h"

using ui::MainWindow;
using ui::WeightColumn;

namespace {

core::Scene fiveWeights() {
  core::Scene scene = core::withWeightCount(core::Scene(), 4);
  core::Weight ball;
  ball.position = {0.5, 0.25};
  scene.weights.push_back(ball);
  scene.solvers = {{.method = "rk4"}};
  return scene;
}

/// A window with the table open and the keyboard in it.
class TableWindow {
 public:
  explicit TableWindow(const core::Scene& scene) : window(scene) {
    tests::showInFront(window);
    QTest::keyClick(&window, Qt::Key_T, Qt::ControlModifier);
    table = window.findChild<ui::WeightsTable*>();
    view = table->view();
  }
  ~TableWindow() { window.editor()->setSaved(); }
  Q_DISABLE_COPY_MOVE(TableWindow)

  QModelIndex cell(int row, WeightColumn column) const {
    return view->model()->index(row, static_cast<int>(column));
  }

  /// With the mouse, as a person does.
  void click(int row, WeightColumn column, Qt::KeyboardModifiers modifiers = {}) const {
    view->scrollTo(cell(row, column));
    QTest::mouseClick(view->viewport(), Qt::LeftButton, modifiers,
                      view->visualRect(cell(row, column)).center());
  }

  /// Types into the cells that are selected.
  void type(const QString& text) const {
    QTest::keyClick(view, text[0].toLatin1());
    auto* line = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    QVERIFY(line);
    QTest::keyClicks(line, text.mid(1));
    QTest::keyClick(line, Qt::Key_Return);
    QCoreApplication::processEvents();  // a cell is left when its keys are done
  }

  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) const {
    QTest::keyClick(view, key, modifiers);
  }

  const std::vector<core::Weight>& weights() const { return window.editor()->draft().weights; }

  QString refusal() const { return table->findChild<ui::MessageBar*>()->message(); }

  MainWindow window;
  ui::WeightsTable* table;
  QTableView* view;
};

}  // namespace

class WeightsTableWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void opensByKeyAndFromTheWeightsPanel();
  void showsEveryValueWithItsUnit();
  void aTypedValueGoesToAllSelectedRows();
  void aWrongValueIsRefusedInWords();
  void choosesWhatAWeightHangsOn();
  void choosesAColor();
  void addsDuplicatesAndRemovesByKeyAndButton();
  void copiesToAndPastesFromTheClipboard();
  void aPasteWithAFaultChangesNothing();
  void fillsDown();
  void undoesInTheTable();
  void marksWhatCannotRun();
  void keepsStepWithTheSelectedWeight();
  void keysOfTheTableAreItsOwnAndOthersTheWindows();
  void aHundredThousandRowsStayQuick();

 private:
  QTemporaryDir m_folder;
};

void WeightsTableWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void WeightsTableWindowTest::opensByKeyAndFromTheWeightsPanel() {
  MainWindow window(fiveWeights());
  window.show();
  QVERIFY(QTest::qWaitForWindowActive(&window));
  auto* dock = window.findChild<QDockWidget*>("weightsTable");
  auto* view = window.findChild<ui::WeightsTable*>()->view();
  QVERIFY(view->visibleRegion().isEmpty());
  QTest::keyClick(&window, Qt::Key_T, Qt::ControlModifier);
  QTRY_VERIFY(!view->visibleRegion().isEmpty());
  QVERIFY(view->hasFocus());
  dock->close();
  window.findChild<QDockWidget*>("weights")->raise();
  QTest::mouseClick(window.findChild<ui::WeightsForm*>()->findChild<QPushButton*>(),
                    Qt::LeftButton);
  QTRY_VERIFY(!view->visibleRegion().isEmpty());
}

void WeightsTableWindowTest::showsEveryValueWithItsUnit() {
  core::Scene scene = fiveWeights();
  scene.weights[1].rope->angle = 70 * std::numbers::pi / 180;
  const TableWindow open(scene);
  const auto* model = open.view->model();
  QCOMPARE(model->headerData(0, Qt::Horizontal).toString(), QString("Mass\n[kg]"));
  QCOMPARE(model->headerData(8, Qt::Horizontal).toString(), QString("Start angle\n[°]"));
  QCOMPARE(model->headerData(1, Qt::Vertical).toString(), QString("2"));
  QStringList hanging;
  QStringList free;
  for (int column = 0; column < ui::kWeightColumnCount; ++column) {
    hanging << model->index(1, column).data().toString();
    free << model->index(4, column).data().toString();
  }
  QCOMPARE(hanging.join('|'), QString("0.19|0.02|0.47|automatic|rope|1.5|3|1|70|0||||"));
  QCOMPARE(free.join('|'), QString("0.19|0.02|0.47|automatic|nothing||||||0.5|0.25|0|0"));
}

void WeightsTableWindowTest::aTypedValueGoesToAllSelectedRows() {
  const TableWindow open(fiveWeights());
  open.click(1, WeightColumn::kMass);
  open.click(3, WeightColumn::kMass, Qt::ShiftModifier);
  open.type("0,5");
  QCOMPARE(open.weights()[0].mass, 0.19);
  for (int row : {1, 2, 3}) QCOMPARE(open.weights()[row].mass, 0.5);
  QCOMPARE(open.weights()[4].mass, 0.19);
  QCOMPARE(open.window.editor()->undoWords(), QString("change of mass"));
  // A row that has no angle stays as it is.
  open.click(3, WeightColumn::kAngle);
  open.click(4, WeightColumn::kAngle, Qt::ControlModifier);
  open.view->setCurrentIndex(open.cell(3, WeightColumn::kAngle));
  open.type("-30");
  QCOMPARE(open.weights()[3].rope->angle, -std::numbers::pi / 6);
  QVERIFY(!open.weights()[4].rope);
}

void WeightsTableWindowTest::aWrongValueIsRefusedInWords() {
  const TableWindow open(fiveWeights());
  open.click(2, WeightColumn::kDragCoefficient);
  open.type("11");
  QCOMPARE(open.refusal(),
           QString("Nothing was changed. Weight 3, Drag coefficient: must be from 0 to 10, "
                   "got “11”"));
  QVERIFY(!open.window.editor()->canUndo());
  open.type("2");
  QCOMPARE(open.refusal(), QString());
  QCOMPARE(open.weights()[2].dragCoefficient, 2.0);
}

void WeightsTableWindowTest::choosesWhatAWeightHangsOn() {
  const TableWindow open(fiveWeights());
  open.click(0, WeightColumn::kHangsOn);
  open.press(Qt::Key_Return);
  auto* chooser = qobject_cast<QComboBox*>(QApplication::focusWidget());
  QVERIFY(chooser);
  QTest::keyClick(chooser, Qt::Key_R);  // is no reset here
  QTest::keyClick(chooser, Qt::Key_Home);
  QTest::keyClick(chooser, Qt::Key_Return);
  QCoreApplication::processEvents();
  QCOMPARE(open.window.controller()->time(), 0.0);
  QVERIFY(!open.weights()[0].rope);
  QVERIFY(!(open.cell(0, WeightColumn::kLength).flags() & Qt::ItemIsEditable));
  QVERIFY(open.cell(0, WeightColumn::kX).flags() & Qt::ItemIsEditable);
}

void WeightsTableWindowTest::choosesAColor() {
  const TableWindow open(fiveWeights());
  open.click(1, WeightColumn::kColor);
  open.press(Qt::Key_Return);
  auto* chooser = qobject_cast<QComboBox*>(QApplication::focusWidget());
  QVERIFY(chooser);
  QCOMPARE(chooser->count(), 9);  // by position in the list, or one of those that stay apart
  QTest::keyClick(chooser, Qt::Key_Down);
  const QString chosen = chooser->currentText();
  QTest::keyClick(chooser, Qt::Key_Return);
  QCoreApplication::processEvents();
  QVERIFY(open.weights()[1].color);
  QCOMPARE(open.cell(1, WeightColumn::kColor).data().toString(), chosen);
  QVERIFY(!open.weights()[0].color);
}

void WeightsTableWindowTest::addsDuplicatesAndRemovesByKeyAndButton() {
  const TableWindow open(fiveWeights());
  const auto before = open.weights();
  open.press(Qt::Key_Insert);
  QCOMPARE(open.weights().size(), std::size_t{6});
  QCOMPARE(open.view->currentIndex().row(), 5);
  open.click(0, WeightColumn::kMass);
  open.click(4, WeightColumn::kMass, Qt::ControlModifier);
  for (QToolButton* button : open.window.findChildren<QToolButton*>())
    if (button->text() == "Duplicate") QTest::mouseClick(button, Qt::LeftButton);
  QCOMPARE(open.weights().size(), std::size_t{8});
  QVERIFY(open.window.editor()->problems().empty());  // beside each other, not on each other
  QVERIFY(open.weights()[6].rope.has_value());
  QVERIFY(!open.weights()[7].rope);
  open.click(5, WeightColumn::kMass);
  open.click(7, WeightColumn::kMass, Qt::ShiftModifier);
  open.press(Qt::Key_Delete);
  QVERIFY(open.weights() == before);
  for (int i = 0; i < 3; ++i) open.window.editor()->undo();
  QVERIFY(open.weights() == before);
  QVERIFY(!open.window.editor()->canUndo());
}

void WeightsTableWindowTest::copiesToAndPastesFromTheClipboard() {
  const TableWindow open(fiveWeights());
  open.click(1, WeightColumn::kMass);
  open.click(2, WeightColumn::kRadius, Qt::ShiftModifier);
  open.press(Qt::Key_C, Qt::ControlModifier);
  QCOMPARE(QApplication::clipboard()->text(), QString("0.19\t0.02\n0.19\t0.02\n"));
  QApplication::clipboard()->setText("0,3\t0,01\n0.4\t0.015\n");  // as other programs do
  open.click(3, WeightColumn::kMass);
  open.press(Qt::Key_V, Qt::ControlModifier);
  QCOMPARE(open.weights()[3].mass, 0.3);
  QCOMPARE(open.weights()[4].radius, 0.015);
  // Whole rows keep their place, and may be new ones.
  open.press(Qt::Key_A, Qt::ControlModifier);
  open.press(Qt::Key_C, Qt::ControlModifier);
  const QString all = QApplication::clipboard()->text();
  QCOMPARE(all.count('\n'), 6);
  QApplication::clipboard()->setText(all.section('\n', 0, 1).replace("0.4\t", "1.2\t"));
  open.press(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
  QCOMPARE(open.weights().size(), std::size_t{6});
}

void WeightsTableWindowTest::aPasteWithAFaultChangesNothing() {
  const TableWindow open(fiveWeights());
  const auto before = open.weights();
  QApplication::clipboard()->setText("1\t0.01\n2\tlarge\n");
  open.click(2, WeightColumn::kMass);
  open.press(Qt::Key_V, Qt::ControlModifier);
  QVERIFY2(open.refusal().startsWith("Nothing was changed. Weight 4, Radius: must be from"),
           qPrintable(open.refusal()));
  QVERIFY(open.weights() == before);
  QVERIFY(!open.window.isWindowModified());
  QCOMPARE(QApplication::clipboard()->text(), QString("1\t0.01\n2\tlarge\n"));
}

void WeightsTableWindowTest::fillsDown() {
  core::Scene scene = fiveWeights();
  scene.weights[1].mass = 0.7;
  scene.weights[1].radius = 0.03;
  const TableWindow open(scene);
  open.click(1, WeightColumn::kMass);
  open.click(4, WeightColumn::kRadius, Qt::ShiftModifier);
  open.press(Qt::Key_D, Qt::ControlModifier);
  for (int row : {1, 2, 3, 4}) {
    QCOMPARE(open.weights()[row].mass, 0.7);
    QCOMPARE(open.weights()[row].radius, 0.03);
  }
  QCOMPARE(open.weights()[0].mass, 0.19);
}

void WeightsTableWindowTest::undoesInTheTable() {
  const TableWindow open(fiveWeights());
  open.click(0, WeightColumn::kMass);
  open.type("3");
  open.press(Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(open.cell(0, WeightColumn::kMass).data().toString(), QString("0.19"));
  open.press(Qt::Key_Y, Qt::ControlModifier);
  QCOMPARE(open.cell(0, WeightColumn::kMass).data().toString(), QString("3"));
}

void WeightsTableWindowTest::marksWhatCannotRun() {
  const TableWindow open(fiveWeights());
  open.click(4, WeightColumn::kX);
  open.type("7");
  QCOMPARE(open.window.editor()->problems().size(), std::size_t{1});
  QVERIFY(open.cell(4, WeightColumn::kX).data(Qt::BackgroundRole).isValid());
  QVERIFY(open.cell(4, WeightColumn::kX).data(Qt::ToolTipRole).toString().contains("room"));
  open.type("0.7");
  QVERIFY(!open.cell(4, WeightColumn::kX).data(Qt::BackgroundRole).isValid());
}

void WeightsTableWindowTest::keepsStepWithTheSelectedWeight() {
  const TableWindow open(fiveWeights());
  auto* selection = open.window.findChild<ui::Selection*>();
  selection->select(3);
  QCOMPARE(open.view->currentIndex().row(), 3);
  open.click(1, WeightColumn::kY);
  QCOMPARE(selection->weight(), std::optional(1));
  QCOMPARE(open.window.findChild<ui::WeightsForm*>()->findChild<QSpinBox*>()->value(), 2);
}

void WeightsTableWindowTest::keysOfTheTableAreItsOwnAndOthersTheWindows() {
  const TableWindow open(fiveWeights());
  open.click(1, WeightColumn::kMass);
  open.press(Qt::Key_Right);
  QCOMPARE(open.view->currentIndex(), open.cell(1, WeightColumn::kRadius));
  QCOMPARE(open.window.controller()->time(), 0.0);
  open.press(Qt::Key_Space);
  QVERIFY(open.window.controller()->isPlaying());
}

void WeightsTableWindowTest::aHundredThousandRowsStayQuick() {
  core::Scene scene;
  scene.room.width = 400;
  core::Weight ball;
  for (int i = 0; i < core::kMostWeights; ++i) {
    const int row = i / 3900;
    ball.position = {0.1 + 0.1 * (i % 3900), 0.1 + 0.1 * row};
    scene.weights.push_back(ball);
  }
  ui::SceneEditor editor(scene);
  ui::Selection selection(&editor);
  ui::WeightsTable table(&editor, &selection);
  table.resize(1000, 300);
  table.show();
  QVERIFY(QTest::qWaitForWindowExposed(&table));
  table.view()->selectAll();
  table.copy();
  QCOMPARE(QApplication::clipboard()->text().count('\n'), core::kMostWeights + 1);
  table.fillDown();
  QVERIFY(editor.canUndo());
  table.view()->setCurrentIndex(table.view()->model()->index(70000, 0));
  table.remove();
  QCOMPARE(editor.draft().weights.size(), std::size_t{core::kMostWeights - 1});
  QCOMPARE(selection.weight(), std::optional(70000));
}

QTEST_MAIN(WeightsTableWindowTest)
#include "weights_table_window_test.moc"
