#include <cmath>

#include <QAction>
#include <QFile>
#include <QImage>
#include <QLocale>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <QToolButton>

#include "tests/support/controlled_runs.h"
#include "tests/support/shown_window.h"
#include "tests/support/window_hand.h"
#include "ui/control/commands.h"
#include "ui/control/exports.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/selection.h"
#include "ui/main_window.h"
#include "ui/view/scene_drawing.h"
#include "ui/view/scene_look.h"
#include "ui/view/shown_scene.h"
#include "ui/view/trails.h"

using Eigen::Vector2d;
using ui::Command;
using ui::ToolPart;

namespace {

/// A weight of 1 kg at rest on a rope of 1 m under g = 10 m/s²; it pulls with 10 N. A free one
/// that flies at 3 m/s, and two runs.
core::Scene twoWeights() {
  core::Scene scene;
  scene.gravity = 10;
  scene.airDensity = 0;
  core::Weight hanging;
  hanging.mass = 1;
  hanging.rope = core::Rope{{1, 2.5}, 1, 0, 0, false};
  core::Weight flying;
  flying.mass = 1;
  flying.position = {2, 2};
  flying.velocity = {3, 0};
  scene.weights = {hanging, flying};
  scene.solvers = {{.method = "rk4"}, {.method = "euler"}};
  return scene;
}

class Window : public tests::ShownWindow {
 public:
  Window() : ShownWindow(twoWeights(), {1400, 1000}), hand(*this) {}

  const ui::MeasuringTools& tools() const { return hand.view()->shown().marks.tools; }
  ui::Drawing drawing() const {
    const ui::SceneView* view = hand.view();
    return ui::sceneDrawing(view->shown(), ui::Trails(), view->camera(), view->look());
  }
  /// All words in the picture, with plain spaces.
  QStringList words() const {
    QStringList all;
    const ui::Drawing shown = drawing();
    for (const ui::Text& text : shown.texts) all << QString(text.words).replace(QChar(0x00a0), ' ');
    return all;
  }
  /// Length in the picture of the arrow of this color at this place [px]; 0: none.
  double arrowAt(const Vector2d& place, const QColor& color) const {
    const ui::Drawing shown = drawing();
    for (const ui::Arrow& arrow : shown.layers[ui::kFrontLayer].arrows)
      if ((arrow.from - place).norm() < 1e-9 && arrow.color == color.rgb())
        return hand.view()->camera().scale() * (arrow.to - arrow.from).norm();
    return 0;
  }
  const ui::Theme& theme() const { return hand.view()->look().theme; }
  QPoint placeOf(ToolPart part) const {
    const ui::SceneView* view = hand.view();
    const double top = ui::wordsTop(view->shown(), view->camera(), view->look());
    return ui::placeOf(tools(), part, top, view->camera(), view->look()).toPoint();
  }
  QImage picture() const { return hand.view()->grab().toImage(); }

  tests::WindowHand hand;
};

}  // namespace

/// Arrows and measuring tools in the window.
class ToolsWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void showsVelocitiesByKey();
  void showsForcesByKey();
  void showsTensionsByKey();
  void switchesByButton();
  void measuresALengthByHand();
  void theRulerSnapsToPivotsAndWeights();
  void measuresAnAngleByHand();
  void movesToolsByKey();
  void theTapeDoesNotHideWeights();
  void toolsStayWhereTheyArePut();
  void timesFromEventToEvent();
  void theStopwatchIsStartedByAClickAndMovedByADrag();
  void theStopwatchStartsAnewWithTheScene();
  void escapeLeavesOneThingAfterTheOther();
  void everyViewOfSplitViewsShowsTheMarks();
  void exportsWhatIsShown();

 private:
  QTemporaryDir m_folder;
};

void ToolsWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void ToolsWindowTest::showsVelocitiesByKey() {
  Window window;
  const QImage before = window.picture();
  window.press(Qt::Key_V, Qt::ShiftModifier);
  // 60 px for 2 m/s, as the words beside the first arrow say
  QVERIFY(std::abs(window.arrowAt({2, 2}, window.theme().kinetic) - 90) < 1e-6);
  QVERIFY(window.words().contains("= 2 m/s"));
  QVERIFY(window.picture() != before);
  window.press(Qt::Key_V, Qt::ShiftModifier);
  QCOMPARE(window.picture(), before);
}

void ToolsWindowTest::showsForcesByKey() {
  Window window;
  window.press(Qt::Key_F, Qt::ShiftModifier);
  QVERIFY(window.words().contains("= 10 N"));
  QVERIFY(std::abs(window.arrowAt({1, 1.5}, window.theme().potential) - 60) < 1e-6);
  QVERIFY(std::abs(window.arrowAt({1, 1.5}, window.theme().lostToRopes) - 60) < 1e-6);
  QCOMPARE(window.arrowAt({2, 2}, window.theme().lostToRopes), 0.0);
  window.press(Qt::Key_C);
  window.press(Qt::Key_Right);  // cut: only gravity is left
  const Vector2d place = window.controller()->run(0).weight(0).position;
  QCOMPARE(window.arrowAt(place, window.theme().lostToRopes), 0.0);
  QVERIFY(window.arrowAt(place, window.theme().potential) > 59);
}

void ToolsWindowTest::showsTensionsByKey() {
  Window window;
  QVERIFY(!window.words().contains("10.00 N"));
  window.press(Qt::Key_T, Qt::ShiftModifier);
  QVERIFY(window.words().contains("10.00 N"));
}

void ToolsWindowTest::switchesByButton() {
  Window window;
  int buttons = 0;
  for (QToolButton* button :
       window.findChild<QToolBar*>("sceneTools")->findChildren<QToolButton*>()) {
    if (!button->defaultAction()) continue;
    const bool before = button->defaultAction()->isChecked();
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY2(button->defaultAction()->isChecked() != before, qPrintable(button->text()));
    ++buttons;
  }
  QCOMPARE(buttons, 7);
  const ui::ShownArrows& arrows = window.hand.view()->shown().marks.arrows;
  QVERIFY(arrows.velocities && arrows.forces && arrows.tensions);
  QVERIFY(window.tools().tape && window.tools().protractor && window.tools().stopwatch);
  QVERIFY(!window.hand.view()->trails());
}

void ToolsWindowTest::measuresALengthByHand() {
  Window window;
  window.press(Qt::Key_D);
  window.hand.drag(window.placeOf(ToolPart::kTapeFrom), window.hand.pixel({1, 1}));
  window.hand.drag(window.placeOf(ToolPart::kTapeTo), window.hand.pixel({2.2, 0.5}));
  const double length = (window.tools().tape->to - window.tools().tape->from).norm();
  // Each end is within a pixel and what the grip was missed by.
  QVERIFY2(std::abs(length - 1.3) < 4 * window.hand.grain(), qPrintable(QString::number(length)));
  QVERIFY(window.words().contains(QString::number(length, 'f', 3) + " m"));
  window.press(Qt::Key_D);
  QVERIFY(!window.tools().tape);
  window.press(Qt::Key_D);  // comes back where it was
  QCOMPARE((window.tools().tape->to - window.tools().tape->from).norm(), length);
}

void ToolsWindowTest::theRulerSnapsToPivotsAndWeights() {
  Window window;
  window.press(Qt::Key_D);
  const auto lead = [&](ToolPart part, const Vector2d& to) {
    window.hand.drag(window.placeOf(part), window.hand.pixel(to) + QPoint(6, -5),
                     Qt::ControlModifier);
  };
  lead(ToolPart::kTapeFrom, {1, 2.5});
  lead(ToolPart::kTapeTo, {1, 1.5});
  QVERIFY((window.tools().tape->from - Vector2d(1, 2.5)).norm() < 1e-9);
  QVERIFY((window.tools().tape->to - Vector2d(1, 1.5)).norm() < 1e-9);
  QVERIFY(window.words().contains("1.000 m"));
}

void ToolsWindowTest::measuresAnAngleByHand() {
  Window window;
  window.press(Qt::Key_A);
  window.hand.drag(window.placeOf(ToolPart::kVertex), window.hand.pixel({2, 1}));
  window.hand.drag(window.placeOf(ToolPart::kFirstArm), window.hand.pixel({3, 1}));
  window.hand.drag(window.placeOf(ToolPart::kSecondArm), window.hand.pixel({2, 2}));
  const double angle = window.tools().protractor->angle() * 180 / std::acos(-1);
  // Three points, each within two pixels, seen from 1 m.
  QVERIFY2(std::abs(angle - 90) < 60 * 6 * window.hand.grain(), qPrintable(QString::number(angle)));
  QVERIFY(window.words().contains(QString::number(angle, 'f', 1) + "°"));
}

void ToolsWindowTest::movesToolsByKey() {
  Window window;
  window.press(Qt::Key_N);
  window.press(Qt::Key_D);
  const ui::MeasuringTape before = *window.tools().tape;
  window.press(Qt::Key_H);
  QCOMPARE(window.tools().chosen, ToolPart::kTapeFrom);
  window.press(Qt::Key_H);
  for (int i = 0; i < 5; ++i) window.press(Qt::Key_Right, Qt::AltModifier);
  window.press(Qt::Key_Up, Qt::AltModifier);
  QVERIFY((window.tools().tape->to - before.to - Vector2d(0.05, 0.01)).norm() < 1e-9);
  QCOMPARE(window.tools().tape->from, before.from);
  QVERIFY(!window.editor()->canUndo());  // the selected weight stayed where it was
  window.press(Qt::Key_Escape);
  QCOMPARE(window.tools().chosen, std::nullopt);
  QCOMPARE(window.selection()->weight(), 0);
  window.press(Qt::Key_Right, Qt::AltModifier);
  QVERIFY(window.editor()->canUndo());
  window.editor()->setSaved();
}

void ToolsWindowTest::theTapeDoesNotHideWeights() {
  Window window;
  window.press(Qt::Key_D);
  window.hand.drag(window.placeOf(ToolPart::kTapeFrom), window.hand.pixel({1.5, 2}));
  window.hand.drag(window.placeOf(ToolPart::kTapeTo), window.hand.pixel({2.5, 2}));
  window.hand.click({2, 2});
  QCOMPARE(window.selection()->weight(), 1);
  window.hand.drag(window.hand.pixel({2.3, 2}), window.hand.pixel({2.3, 1.5}));
  QVERIFY((window.tools().tape->to - Vector2d(2.5, 1.5)).norm() < 4 * window.hand.grain());
}

void ToolsWindowTest::toolsStayWhereTheyArePut() {
  Window window;
  window.press(Qt::Key_D);
  window.press(Qt::Key_A);
  const Vector2d tape = window.tools().tape->to, arm = window.tools().protractor->first;
  window.controller()->goTo(1);
  window.press(Qt::Key_R);
  window.editor()->change([](core::Scene& scene) { scene.gravity = 5; });
  QCOMPARE(window.tools().tape->to, tape);
  QCOMPARE(window.tools().protractor->first, arm);
  window.editor()->setSaved();
}

/// The time of a fall: from the start to the first impact.
void ToolsWindowTest::timesFromEventToEvent() {
  Window window;
  window.press(Qt::Key_S);  // shows it, too
  QVERIFY(window.tools().stopwatch->isRunning());
  window.press(Qt::Key_I);
  window.press(Qt::Key_S);
  // From 2 m down to the radius of 0.02 m, as a parabola: exact for Runge–Kutta 4, up to what
  // locating the impact leaves.
  const double fall = std::sqrt(2 * 1.98 / 10);
  const double reading = window.tools().stopwatch->reading(7);
  QVERIFY2(std::abs(reading - fall) < 1e-9, qPrintable(QString::number(reading, 'g', 15)));
  window.press(Qt::Key_Right);
  QVERIFY(window.words().contains(QString::number(fall, 'f', 3) + " s"));
  window.press(Qt::Key_S, Qt::ShiftModifier);
  QVERIFY(window.words().contains("0.000 s"));
}

void ToolsWindowTest::theStopwatchIsStartedByAClickAndMovedByADrag() {
  Window window;
  window.press(Qt::Key_K);
  const QPoint face = window.placeOf(ToolPart::kStopwatch) + QPoint(20, 20);
  QTest::mouseClick(window.hand.view(), Qt::LeftButton, {}, face);
  QVERIFY(window.tools().stopwatch->isRunning());
  window.hand.drag(face, face - QPoint(200, -100));
  QVERIFY(window.tools().stopwatch->isRunning());
  QCOMPARE(window.placeOf(ToolPart::kStopwatch) + QPoint(20, 20), face - QPoint(200, -100));
}

void ToolsWindowTest::theStopwatchStartsAnewWithTheScene() {
  Window window;
  window.controller()->goTo(0.5);
  window.press(Qt::Key_S);
  window.press(Qt::Key_R);
  QVERIFY(window.tools().stopwatch->isRunning());
  window.controller()->goTo(0.25);
  QCOMPARE(window.tools().stopwatch->reading(0.25), 0.25);
  window.press(Qt::Key_S);
  window.press(Qt::Key_R);  // what it stopped at can still be read
  QCOMPARE(window.tools().stopwatch->reading(0), 0.25);
}

void ToolsWindowTest::escapeLeavesOneThingAfterTheOther() {
  Window window;
  window.press(Qt::Key_N);
  window.press(Qt::Key_D);
  window.press(Qt::Key_H);
  // Each look at the clock takes a second: one step between two frames.
  window.controller()->setStopwatch(tests::ticking(1));
  window.controller()->goTo(100);
  QVERIFY(window.controller()->isTravelling());
  window.press(Qt::Key_Escape);
  QVERIFY(!window.controller()->isTravelling());
  QCOMPARE(window.tools().chosen, ToolPart::kTapeFrom);
  QCOMPARE(window.selection()->weight(), 0);
  window.press(Qt::Key_Escape);
  QCOMPARE(window.tools().chosen, std::nullopt);
  QCOMPARE(window.selection()->weight(), 0);
  window.press(Qt::Key_Escape);
  QCOMPARE(window.selection()->weight(), std::nullopt);
}

void ToolsWindowTest::everyViewOfSplitViewsShowsTheMarks() {
  Window window;
  window.press(Qt::Key_D);
  window.press(Qt::Key_N);
  window.press(Qt::Key_V);
  const auto views = window.findChildren<ui::SceneView*>();
  QCOMPARE(views.size(), 2);
  for (const ui::SceneView* view : views) {
    QVERIFY(view->shown().marks.tools.tape);
    QCOMPARE(view->shown().marks.selection->weight, 0);
  }
  QTest::mouseClick(views[1], Qt::LeftButton, {}, views[1]->camera().toPixels({2, 2}).toPoint());
  QCOMPARE(views[0]->shown().marks.selection->weight, 1);
}

void ToolsWindowTest::exportsWhatIsShown() {
  Window window;
  const auto exported = [&](const QString& name) {
    QFile file(m_folder.filePath(name));
    window.exports()->savePicture(file.fileName());
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  };
  const QByteArray plain = exported("plain.svg");
  window.press(Qt::Key_N);  // nobody can move a weight on paper
  QCOMPARE(exported("selected.svg"), plain);
  QByteArray last = plain;
  const std::vector<std::pair<Qt::Key, Qt::KeyboardModifiers>> keys = {
      {Qt::Key_V, Qt::ShiftModifier},
      {Qt::Key_F, Qt::ShiftModifier},
      {Qt::Key_T, Qt::ShiftModifier},
      {Qt::Key_D, {}},
      {Qt::Key_A, {}},
      {Qt::Key_K, {}}};
  for (const auto& [key, modifiers] : keys) {
    window.press(key, modifiers);
    const QByteArray next = exported("next.svg");
    QVERIFY2(next != last, qPrintable(QKeySequence(key).toString()));
    last = next;
  }
}

QTEST_MAIN(ToolsWindowTest)
#include "tools_window_test.moc"
