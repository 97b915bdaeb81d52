#include <cmath>
#include <numbers>

#include <QAction>
#include <QLocale>
#include <QSettings>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>

#include "core/scene/angle.h"
#include "tests/support/shown_window.h"
#include "tests/support/window_hand.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/selection.h"
#include "ui/main_window.h"
#include "ui/panels/message_bar.h"
#include "ui/view/picking.h"
#include "ui/view/shown_scene.h"

using Eigen::Vector2d;
using ui::Command;

namespace {

constexpr int kHanging = 0, kFree = 1, kTiny = 2;

/// One weight on a rope at 30°, a free one, and one too small to be seen as large as it is.
core::Scene threeKinds() {
  core::Scene scene;
  scene.airDensity = 0;
  core::Weight hanging;
  hanging.radius = 0.05;
  hanging.rope = core::Rope{{1, 2.5}, 1, core::radians(30), 0, false};
  core::Weight free;
  free.radius = 0.1;
  free.position = {3, 1};
  core::Weight tiny;
  tiny.radius = 1e-4;
  tiny.position = {2, 0.5};
  scene.weights = {hanging, free, tiny};
  scene.solvers = {{.method = "rk4"}};
  return scene;
}

/// A window in front with that scene, and a hand in it.
class Window : public tests::ShownWindow {
 public:
  explicit Window(const core::Scene& scene = threeKinds())
      : ShownWindow(scene, {1400, 1000}), hand(*this) {}
  ~Window() override { editor()->setSaved(); }

  const core::Weight& weight(int index) const { return editor()->scene()->weights[index]; }
  const core::Weight& drafted(int index) const { return editor()->draft().weights[index]; }
  const core::Rope& rope() const { return *weight(kHanging).rope; }
  Vector2d start(int index) const { return core::startPosition(weight(index)); }
  /// Where the velocity of the selected weight is taken hold of.
  QPoint grip() const {
    const ui::ShownScene& shown = hand.view()->shown();
    return ui::velocityGrip(weight(shown.marks.selection->weight), shown.marks.arrows.scales,
                            hand.view()->camera())
        .toPoint();
  }
  double pixelsPerSpeed() const {
    return hand.view()->shown().marks.arrows.scales.pixelsPerSpeed();
  }
  QString words() const {
    const auto& selection = hand.view()->shown().marks.selection;
    return selection ? selection->words.join(", ") : QString();
  }
  bool hasMessage() const {
    for (const ui::MessageBar* bar : findChildren<ui::MessageBar*>())
      if (bar->isVisible()) return true;
    return false;
  }

  tests::WindowHand hand;
};

/// Where a rope of this angle [°] and length points from the pivot of the hanging weight.
Vector2d onRope(double angle, double length) {
  const double radians = core::radians(angle);
  return Vector2d(1, 2.5) + length * Vector2d(std::sin(radians), -std::cos(radians));
}

QString number(double value) {
  return QString::number(value, 'g', 12);
}

}  // namespace

/// Hand and keys at the weights of the scene in the window.
class SceneWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void aClickSelectsTheNearestWeight();
  void keysWalkRoundTheWeights();
  void aDragTurnsARope();
  void aDragWithShiftSetsTheLength();
  void aDragPlacesAFreeWeight();
  void aDragOfItsArrowSetsTheVelocity();
  void aDragOfItsArrowTurnsAWeightOnARope();
  void controlSnaps();
  void aWholeDragIsUndoneAtOnce();
  void escapePutsADraggedWeightBack();
  void whereItDoesNotFitItStaysADraft();
  void weightsAreHeldFastOnceTimeHasPassed();
  void theGroundMovesTheView();
  void keysMoveTheSelectedWeight();
  void keysSetItsVelocity();
  void keysRestartARunLikeAForm();

 private:
  QTemporaryDir m_folder;
};

void SceneWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void SceneWindowTest::aClickSelectsTheNearestWeight() {
  Window window;
  for (const int weight : {kHanging, kFree, kTiny}) {
    window.hand.click(window.start(weight), {3, -4});
    QCOMPARE(window.selection()->weight(), weight);
    QCOMPARE(window.hand.view()->shown().marks.selection->weight, weight);
  }
  window.hand.click({2, 1.5});
  QCOMPARE(window.selection()->weight(), std::nullopt);
  window.hand.click(window.start(kFree));
  window.press(Qt::Key_Escape);
  QCOMPARE(window.selection()->weight(), std::nullopt);
  QVERIFY(!window.hand.view()->shown().marks.selection);
  QVERIFY(!window.isWindowModified());
}

void SceneWindowTest::keysWalkRoundTheWeights() {
  Window window;
  for (const int weight : {0, 1, 2, 0}) {
    window.press(Qt::Key_N);
    QCOMPARE(window.selection()->weight(), weight);
  }
  window.press(Qt::Key_N, Qt::ShiftModifier);
  QCOMPARE(window.selection()->weight(), 2);
}

void SceneWindowTest::aDragTurnsARope() {
  Window window;
  window.hand.press(window.hand.pixel(window.start(kHanging)));
  // Further away than the rope is long: only the direction counts.
  window.hand.move(window.hand.pixel(onRope(-50, 1.2)));
  // Two pixels off at most, seen from 1.2 m, and rounded to less.
  const double grain = core::degrees(2 * window.hand.grain() / 1.2) + 0.1;
  QVERIFY2(std::abs(core::degrees(window.rope().angle) + 50) < grain,
           qPrintable(number(core::degrees(window.rope().angle))));
  QCOMPARE(window.rope().length, 1.0);
  QVERIFY2(window.words().contains(number(-core::degrees(window.rope().angle)) + "°"),
           qPrintable(window.words()));
  // The weight is where it is shown, within what it is drawn from.
  QVERIFY((window.controller()->run(0).weight(kHanging).position - window.start(kHanging)).norm() <
          1e-12);
  window.hand.release({});
}

void SceneWindowTest::aDragWithShiftSetsTheLength() {
  Window window;
  window.hand.drag(window.start(kHanging), onRope(30, 0.6), Qt::ShiftModifier);
  QVERIFY2(std::abs(window.rope().length - 0.6) < 2 * window.hand.grain(),
           qPrintable(number(window.rope().length)));
  QCOMPARE(window.rope().angle, core::radians(30));
}

void SceneWindowTest::aDragPlacesAFreeWeight() {
  Window window;
  // Held beside its middle it does not jump.
  const QPoint held = window.hand.pixel(window.start(kFree)) + QPoint(9, 5);
  const QPoint way = window.hand.pixel({2, 2}) - window.hand.pixel({3, 1});
  window.hand.drag(held, held + way);
  const Vector2d place = window.weight(kFree).position;
  QVERIFY2((place - Vector2d(2, 2)).norm() < 2 * window.hand.grain(),
           qPrintable(number(place.x()) + ' ' + number(place.y())));
  QCOMPARE(window.weight(kFree).velocity, Vector2d(0, 0));
}

void SceneWindowTest::aDragOfItsArrowSetsTheVelocity() {
  Window window;
  window.hand.click(window.start(kFree));
  const QPoint center = window.hand.pixel(window.start(kFree));
  const QPointF wanted = QPointF(1.5, -2) * window.pixelsPerSpeed();  // up on the screen
  window.hand.drag(window.grip(), center + wanted.toPoint());
  const Vector2d velocity = window.weight(kFree).velocity;
  // Center and pointer are up to a pixel off each, and the speed is rounded to less.
  QVERIFY2((velocity - Vector2d(1.5, 2)).norm() < 3 / window.pixelsPerSpeed(),
           qPrintable(number(velocity.x()) + ' ' + number(velocity.y())));
  QCOMPARE(window.weight(kFree).position, Vector2d(3, 1));
  // Its tip can be taken hold of again, and led back to none.
  window.hand.drag(window.grip(), center);
  QVERIFY(window.weight(kFree).velocity.norm() < 3 / window.pixelsPerSpeed());
}

void SceneWindowTest::aDragOfItsArrowTurnsAWeightOnARope() {
  Window window;
  window.hand.click(window.start(kHanging));
  const QPoint center = window.hand.pixel(window.start(kHanging));
  // 2 m/s along the circle, and something across it, which the rope allows no speed.
  const Vector2d along(std::cos(core::radians(30)), std::sin(core::radians(30)));
  const Vector2d across(-along.y(), along.x());
  const Vector2d wanted = window.pixelsPerSpeed() * (2 * along - 0.5 * across);
  window.hand.drag(window.grip(), center + QPointF(wanted.x(), -wanted.y()).toPoint());
  QVERIFY2(std::abs(window.rope().angularVelocity - 2) < 3 / window.pixelsPerSpeed(),
           qPrintable(number(window.rope().angularVelocity)));
  QCOMPARE(window.rope().angle, core::radians(30));
}

void SceneWindowTest::controlSnaps() {
  Window window;
  window.hand.drag(window.start(kHanging), onRope(-41.2, 1), Qt::ControlModifier);
  QCOMPARE(window.rope().angle, core::radians(-40));
  window.hand.drag(window.start(kHanging), onRope(-40, 0.84),
                   Qt::ControlModifier | Qt::ShiftModifier);
  QCOMPARE(window.rope().length, 0.85);
  window.hand.drag(window.start(kFree), {2.29, 1.44}, Qt::ControlModifier);
  QCOMPARE(window.weight(kFree).position, Vector2d(2.3, 1.45));
}

void SceneWindowTest::aWholeDragIsUndoneAtOnce() {
  Window window;
  window.hand.drag(window.start(kFree), {2, 2});
  window.hand.drag(window.start(kFree), {2.5, 1.5});
  window.press(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY((window.weight(kFree).position - Vector2d(2, 2)).norm() < 0.02);
  window.press(Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(window.weight(kFree).position, Vector2d(3, 1));
  QVERIFY(!window.editor()->canUndo());
}

void SceneWindowTest::escapePutsADraggedWeightBack() {
  Window window;
  window.hand.press(window.hand.pixel(window.start(kFree)));
  window.hand.move(window.hand.pixel({2, 2}));
  QVERIFY(window.weight(kFree).position != Vector2d(3, 1));
  window.press(Qt::Key_Escape);
  QCOMPARE(window.weight(kFree).position, Vector2d(3, 1));
  window.hand.move(window.hand.pixel({2.5, 2}));
  QCOMPARE(window.weight(kFree).position, Vector2d(3, 1));
  window.hand.release({});
  QCOMPARE(window.selection()->weight(), kFree);
}

void SceneWindowTest::whereItDoesNotFitItStaysADraft() {
  Window window;
  const Vector2d before = window.start(kFree);
  const Vector2d onTheOther = window.start(kHanging);
  window.hand.press(window.hand.pixel(before));
  window.hand.move(window.hand.pixel(onTheOther));
  QCOMPARE(window.start(kFree), before);
  QVERIFY((window.drafted(kFree).position - onTheOther).norm() < 2 * window.hand.grain());
  const auto& selection = window.hand.view()->shown().marks.selection;
  QVERIFY(selection->rejected);
  QCOMPARE(selection->rejected->position, window.drafted(kFree).position);
  QVERIFY2(window.words().contains("overlaps"), qPrintable(window.words()));
  // A bar over the scene would push it away from under the hand.
  QVERIFY(!window.hasMessage());
  window.hand.release(window.hand.pixel(onTheOther));
  QVERIFY(window.hasMessage());
  // What is refused can be taken hold of where it is shown.
  QCoreApplication::processEvents();
  window.hand.drag(window.drafted(kFree).position, {2, 2});
  QVERIFY((window.start(kFree) - Vector2d(2, 2)).norm() < 4 * window.hand.grain());
  QVERIFY(!window.hand.view()->shown().marks.selection->rejected);
  QVERIFY(!window.hasMessage());
  // Outside of the room likewise.
  QCoreApplication::processEvents();
  window.hand.drag(window.start(kFree), {4.5, 2});
  QVERIFY2(window.words().contains("outside"), qPrintable(window.words()));
  QVERIFY(window.hasMessage());
}

void SceneWindowTest::weightsAreHeldFastOnceTimeHasPassed() {
  Window window;
  window.press(Qt::Key_Right);
  const Vector2d before = window.start(kFree);
  const QPoint center = window.hand.pixel(window.controller()->run(0).weight(kFree).position);
  const Vector2d seen = window.hand.place({0, 0});
  window.hand.drag(center, center + QPoint(40, 30));
  QCOMPARE(window.selection()->weight(), kFree);
  QCOMPARE(window.start(kFree), before);
  QVERIFY(!window.editor()->canUndo());
  QVERIFY((window.hand.place({40, 30}) - seen).norm() < 1e-9);  // the view moved
  QVERIFY(window.statusBar()->currentMessage().contains("start"));
  QVERIFY(!window.hand.view()->shown().marks.selection->isMovable);
  window.press(Qt::Key_Home);
  QVERIFY(window.hand.view()->shown().marks.selection->isMovable);
  window.hand.drag(window.start(kFree), {2, 2});
  QVERIFY(window.start(kFree) != before);
  window.press(Qt::Key_Space);
  QVERIFY(!window.hand.view()->shown().marks.selection->isMovable);
}

void SceneWindowTest::theGroundMovesTheView() {
  Window window;
  window.hand.click(window.start(kFree));
  const Vector2d seen = window.hand.place({100, 100});
  const QPoint ground = window.hand.pixel({2, 1.7});
  window.hand.drag(ground, ground + QPoint(-30, 20));
  QVERIFY((window.hand.place({70, 120}) - seen).norm() < 1e-9);
  QCOMPARE(window.selection()->weight(), kFree);  // only a click selects none
}

void SceneWindowTest::keysMoveTheSelectedWeight() {
  Window window;
  QVERIFY(!window.commands().action(Command::kMoveLeft)->isEnabled());
  window.press(Qt::Key_N);
  window.press(Qt::Key_Right, Qt::AltModifier);
  window.press(Qt::Key_Right, Qt::AltModifier);
  window.press(Qt::Key_Left, Qt::AltModifier);
  QCOMPARE(window.rope().angle, core::radians(31));
  window.press(Qt::Key_Up, Qt::AltModifier);
  QCOMPARE(window.rope().length, 0.99);
  window.press(Qt::Key_Down, Qt::AltModifier);
  window.press(Qt::Key_Down, Qt::AltModifier);
  QCOMPARE(window.rope().length, 1.01);
  QVERIFY2(window.words().contains("1.01 m"), qPrintable(window.words()));
  window.press(Qt::Key_N);
  for (int i = 0; i < 10; ++i) window.press(Qt::Key_Left, Qt::AltModifier);
  window.press(Qt::Key_Up, Qt::AltModifier);
  QCOMPARE(window.weight(kFree).position, Vector2d(2.9, 1.01));
  // Steps in one direction are undone together.
  window.press(Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(window.weight(kFree).position, Vector2d(2.9, 1));
  window.press(Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(window.weight(kFree).position, Vector2d(3, 1));
}

void SceneWindowTest::keysSetItsVelocity() {
  Window window;
  window.press(Qt::Key_N);
  for (int i = 0; i < 3; ++i) window.press(Qt::Key_Right, Qt::AltModifier | Qt::ShiftModifier);
  QCOMPARE(window.rope().angularVelocity, core::radians(15));
  window.press(Qt::Key_N);
  for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Up, Qt::Key_Up, Qt::Key_Up, Qt::Key_Down})
    window.press(key, Qt::AltModifier | Qt::ShiftModifier);
  QCOMPARE(window.weight(kFree).velocity, Vector2d(-0.1, 0.2));
}

void SceneWindowTest::keysRestartARunLikeAForm() {
  Window window;
  window.press(Qt::Key_N);
  window.press(Qt::Key_Space);
  window.controller()->passTime(0.1);
  window.press(Qt::Key_Right, Qt::AltModifier);
  QCOMPARE(window.rope().angle, core::radians(31));
  QCOMPARE(window.controller()->time(), 0.0);
  QVERIFY(window.controller()->isPlaying());
}

QTEST_MAIN(SceneWindowTest)
#include "scene_window_test.moc"
