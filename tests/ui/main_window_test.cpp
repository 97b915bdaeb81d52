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

using ui::Command;
using ui::MainWindow;

namespace {

core::Scene swingingScene() {
  core::Scene scene = core::withWeightCount(core::Scene(), 3);
  for (core::Weight& weight : scene.weights) weight.rope->angle = 0.5;
  scene.name = "Three that swing";
  scene.solvers = {{.method = "rk4"}, {.method = "euler"}};
  return scene;
}

/// A light ball shot into air so thick that Euler's step is far too large for it.
core::Scene thickAir() {
  core::Scene scene;
  scene.airDensity = 30;
  scene.room.width = 1000;
  core::Weight ball;
  ball.mass = 1e-3;
  ball.position = {1, 1};
  ball.velocity = {100, 0};
  scene.weights = {ball};
  scene.solvers = {{.method = "euler", .step = 0.05}, {.method = "rk4", .step = 1e-3}};
  return scene;
}

void showAndActivate(MainWindow& window) {
  window.show();
  QVERIFY(QTest::qWaitForWindowActive(&window));
}

/// Lets this much time pass, whatever the clock on the wall says.
void pass(MainWindow& window, double seconds) {
  // Nor does it matter how long the work for it takes.
  window.controller()->setStopwatch([] { return 0.0; });
  window.controller()->passTime(seconds);
}

ui::QuantityField* fieldNamed(const MainWindow& window, const QString& name) {
  for (ui::QuantityField* field : window.findChildren<ui::QuantityField*>()) {
    if (field->spinBox()->accessibleName() == name) return field;
  }
  qFatal("no field named %s", qPrintable(name));
}

void enter(ui::QuantityField* field, const QString& text) {
  field->spinBox()->setFocus();
  field->spinBox()->selectAll();
  QTest::keyClicks(field->spinBox(), text);
  QTest::keyClick(field->spinBox(), Qt::Key_Return);
}

QString messages(const MainWindow& window) {
  QString all;
  for (const ui::MessageBar* bar : window.findChildren<ui::MessageBar*>()) {
    if (bar->isVisibleTo(&window)) all += bar->message();
  }
  return all;
}

/// Presses a button of the message that is about to appear, and returns what it said.
class Answer {
 public:
  explicit Answer(QMessageBox::StandardButton button) {
    QTimer::singleShot(0, &m_context, [this, button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!box) return;
      text = box->text();
      QTest::mouseClick(box->button(button), Qt::LeftButton);
    });
  }

  QString text;

 private:
  QObject m_context;
};

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
  void exportsAChartOfTheRightSize();
  void exportsAPictureOfTheRightSize();
  void exportsTheLedger();
  void offersTheEndingOfTheChosenKind();
  void saysWhenAnExportFails();
  void asksAboutUnsavedChanges_data();
  void asksAboutUnsavedChanges();
  void savesAndOpensScenes();
  void aFileWithAFaultLeavesTheSceneAndSaysWhere();
  void opensEveryBuiltInSceneFromTheMenu();
  void followsAChangeOfColors();
  void everyCommandIsInAMenu();

 private:
  QString inFolder(const QString& name) const { return m_folder.filePath(name); }

  QTemporaryDir m_folder;
};

void MainWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void MainWindowTest::playsAndPausesWithTheSpaceBar() {
  MainWindow window(swingingScene());
  showAndActivate(window);
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
  showAndActivate(window);
  QTest::keyClick(&window, Qt::Key_Right);
  QCOMPARE(window.controller()->time(), 1.0 / 240);
  QTest::keyClick(&window, Qt::Key_Right, Qt::ShiftModifier);
  QCOMPARE(window.controller()->time(), 1.0 / 240 + 1.0 / 60);
}

void MainWindowTest::cutsAndResetsByKey() {
  MainWindow window(swingingScene());
  showAndActivate(window);
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
  showAndActivate(window);
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
  showAndActivate(window);
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
  showAndActivate(window);
  for (int i = 0; i < 3; ++i) QTest::keyClick(&window, Qt::Key_Period);
  QCOMPARE(window.controller()->speed(), 4.0);
  for (int i = 0; i < 10; ++i) QTest::keyClick(&window, Qt::Key_Comma);
  QCOMPARE(window.controller()->speed(), 1.0 / 64);
}

void MainWindowTest::playsByButton() {
  MainWindow window(swingingScene());
  showAndActivate(window);
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
  showAndActivate(window);
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
  showAndActivate(window);
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
  showAndActivate(window);
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
  showAndActivate(window);
  enter(fieldNamed(window, "Gravity"), "5");
  QWidget* focus = window.focusWidget() ? window.focusWidget() : &window;
  QTest::keyClick(focus, Qt::Key_C);
  QVERIFY(!window.controller()->canCut());
  QTest::keyClick(focus, Qt::Key_Space);
  QVERIFY(window.controller()->isPlaying());
}

void MainWindowTest::saysWhichMethodDivergedAndWhen() {
  MainWindow window(thickAir());
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
  core::Scene scene = thickAir();
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

void MainWindowTest::exportsAChartOfTheRightSize() {
  MainWindow window(swingingScene());
  window.controller()->play();
  pass(window, 0.1);
  const QString file = inFolder("chart.png");
  window.exports()->saveChart(file);
  QImageReader reader(file);
  const QImage picture = reader.read();
  QVERIFY2(!picture.isNull(), qPrintable(reader.errorString()));
  // 160 mm at 300 dpi, to the pixel.
  QVERIFY(std::abs(picture.width() - 160 / 25.4 * 300) <= 1);
  QVERIFY(std::abs(picture.dotsPerMeterX() - 300 / 0.0254) < 1);
}

void MainWindowTest::exportsAPictureOfTheRightSize() {
  MainWindow window(swingingScene());
  const QString file = inFolder("scene.png");
  window.exports()->savePicture(file);
  QCOMPARE(QImageReader(file).size(), QSize(2400, 1800));
}

void MainWindowTest::exportsTheLedger() {
  MainWindow window(swingingScene());
  window.controller()->play();
  pass(window, 0.1);
  const QString name = inFolder("ledger.csv");
  window.exports()->saveLedger(name, 1);
  QFile file(name);
  QVERIFY(file.open(QIODevice::ReadOnly));
  const QList<QByteArray> lines = file.readAll().split('\n');
  QCOMPARE(lines.first(), QByteArray("time,kinetic,potential,lost_to_air,lost_to_impacts,"
                                     "lost_to_ropes,lost_to_friction,numerical_drift\r"));
  QVERIFY(lines.size() > 5);
}

void MainWindowTest::offersTheEndingOfTheChosenKind() {
  MainWindow window(swingingScene());
  showAndActivate(window);
  QTimer::singleShot(0, this, [this] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    QVERIFY(dialog);
    dialog->setDirectory(m_folder.path());
    dialog->findChild<QLineEdit*>()->setText("asked");
    QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_Return);
  });
  QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
  QVERIFY(QFile::exists(inFolder("asked.png")));
}

void MainWindowTest::saysWhenAnExportFails() {
  MainWindow window(swingingScene());
  Answer answer(QMessageBox::Ok);
  window.exports()->saveChart(inFolder("no/such/folder.png"));
  QVERIFY(answer.text.startsWith("folder.png was not written:"));
}

void MainWindowTest::asksAboutUnsavedChanges_data() {
  QTest::addColumn<QMessageBox::StandardButton>("button");
  QTest::addColumn<bool>("closed");
  QTest::addColumn<bool>("saved");
  QTest::newRow("save") << QMessageBox::Save << true << true;
  QTest::newRow("discard") << QMessageBox::Discard << true << false;
  QTest::newRow("cancel") << QMessageBox::Cancel << false << false;
}

void MainWindowTest::asksAboutUnsavedChanges() {
  QFETCH(QMessageBox::StandardButton, button);
  QFETCH(bool, closed);
  QFETCH(bool, saved);
  const QString file = inFolder("unsaved.json");
  QCOMPARE(ui::writeSceneFile(file, swingingScene()), QString());
  MainWindow window(swingingScene(), file);
  showAndActivate(window);
  enter(fieldNamed(window, "Gravity"), "1.62");
  Answer answer(button);
  window.close();
  QVERIFY(answer.text.contains("not saved"));
  QCOMPARE(window.isVisible(), !closed);
  QCOMPARE(ui::readSceneFile(file).scene->gravity, saved ? 1.62 : 9.81);
  window.editor()->setSaved();
}

void MainWindowTest::savesAndOpensScenes() {
  const QString file = inFolder("saved.json");
  {
    MainWindow window(swingingScene());
    showAndActivate(window);
    enter(fieldNamed(window, "Air density"), "0");
    QVERIFY(window.files()->saveTo(file));
    QVERIFY(!window.isWindowModified());
    QVERIFY(window.windowTitle().startsWith("saved.json"));
  }
  MainWindow window(swingingScene());
  window.files()->open(file);
  QCOMPARE(window.controller()->scene().airDensity, 0.0);
  QCOMPARE(fieldNamed(window, "Air density")->spinBox()->text(), QString("0 kg/m³"));
}

void MainWindowTest::aFileWithAFaultLeavesTheSceneAndSaysWhere() {
  const QString name = inFolder("fault.json");
  QFile file(name);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(ui::sceneText(swingingScene()).replace("9.81", "-9.81"));
  file.close();
  MainWindow window(swingingScene());
  Answer answer(QMessageBox::Ok);
  window.files()->open(name);
  QVERIFY(answer.text.contains("gravity"));
  QCOMPARE(window.controller()->scene().name, std::string("Three that swing"));
}

void MainWindowTest::opensEveryBuiltInSceneFromTheMenu() {
  MainWindow window(swingingScene());
  for (const QString& name : ui::builtInScenes()) {
    window.files()->openBuiltIn(name);
    QCOMPARE(window.controller()->scene().name, ui::builtInScene(name).name);
    QVERIFY(!window.controller()->isPlaying());
    window.controller()->stepOnce();
  }
}

void MainWindowTest::followsAChangeOfColors() {
  MainWindow window(swingingScene());
  showAndActivate(window);
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
