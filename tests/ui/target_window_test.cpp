// Drives the window as a person does who aims at a target.
#include <cmath>

#include <QAction>
#include <QFile>
#include <QLocale>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/file_content.h"
#include "tests/support/shown_window.h"
#include "tests/support/window_hand.h"
#include "ui/control/commands.h"
#include "ui/control/exports.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/control/scene_target.h"
#include "ui/control/selection.h"
#include "ui/control/target_control.h"
#include "ui/main_window.h"
#include "ui/view/camera.h"
#include "ui/view/scene_area.h"
#include "ui/view/target_drawing.h"

using tests::contentOf;
using ui::Command;

namespace {

/// Two weights that hang still at x = 1 and 2 and are cut at 0.5 s: each falls 1.48 m.
core::Scene twoThatFall() {
  core::Scene scene;
  scene.airDensity = 0;
  scene.room = {.width = 3, .height = 3};
  scene.cutTime = 0.5;
  scene.weights.resize(2);
  for (int i = 0; i < 2; ++i)
    scene.weights[i].rope = core::Rope{.pivot = {1.0 + i, 2.5}, .length = 1};
  scene.solvers = {{.method = "rk4"}, {.method = "euler", .step = 0.05}};
  return scene;
}

/// When they land.
double landingTime() {
  return 0.5 + std::sqrt(2 * 1.48 / 9.81);
}

class Window : public tests::ShownWindow {
 public:
  Window() : ShownWindow(twoThatFall()), hand(*this) {}

  ui::SceneArea* area() const { return findChild<ui::SceneArea*>(); }
  ui::SceneView* view() const { return hand.view(); }
  ui::SceneTarget* aim() const { return target()->target(); }
  QPoint pixelOf(double x) const {
    const auto stripe = ui::targetStripe({x, 0.1}, view()->room(), view()->camera());
    return stripe.center().toPoint();
  }

  tests::WindowHand hand;
};

}  // namespace

class TargetWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void aKeyShowsAndHidesIt();
  void theMouseDragsItAlongTheFloor();
  void draggingAnEndChangesItsWidth();
  void theCursorSaysWhatADragWouldDo();
  void aDoubleClickOnItLeavesTheView();
  void besideItTheMouseMovesTheView();
  void staysInTheRoom();
  void saysWhenTheWeightHitIt();
  void followsTheSelectedWeight();
  void goingBackTakesTheLandingBack();
  void countsOnlyLandingsAfterTheCut();
  void eachSplitViewShowsItsOwnRun();
  void isFoundInAnotherScenesRoom();
  void isInExportedPictures_data();
  void isInExportedPictures();

 private:
  QTemporaryDir m_folder;
};

void TargetWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void TargetWindowTest::aKeyShowsAndHidesIt() {
  Window window;
  QVERIFY(!window.view()->target());
  window.press(Qt::Key_G);
  QVERIFY(window.view()->target());
  QVERIFY(window.commands().action(Command::kTarget)->isChecked());
  window.press(Qt::Key_G);
  QVERIFY(!window.view()->target());
}

void TargetWindowTest::theMouseDragsItAlongTheFloor() {
  Window window;
  window.press(Qt::Key_G);
  const ui::Camera before = window.view()->camera();
  window.hand.drag(window.pixelOf(window.aim()->place().center), window.pixelOf(1));
  // To a pixel, and as many digits as that means.
  QVERIFY(std::abs(window.aim()->place().center - 1) <= 2 * window.hand.grain());
  QCOMPARE(window.view()->target()->place, window.aim()->place());
  QCOMPARE(window.aim()->place().width, 0.3);
  QVERIFY(window.view()->camera() == before);
}

void TargetWindowTest::draggingAnEndChangesItsWidth() {
  Window window;
  window.press(Qt::Key_G);
  window.aim()->setPlace({1.5, 0.6});
  window.hand.drag(window.pixelOf(1.8), window.pixelOf(2));
  QVERIFY(std::abs(window.aim()->place().width - 1) <= 4 * window.hand.grain());
  QCOMPARE(window.aim()->place().center, 1.5);
  window.hand.drag(window.pixelOf(1), window.pixelOf(1.4));
  QVERIFY(std::abs(window.aim()->place().width - 0.2) <= 6 * window.hand.grain());
}

void TargetWindowTest::theCursorSaysWhatADragWouldDo() {
  Window window;
  window.press(Qt::Key_G);
  window.aim()->setPlace({1.5, 0.6});
  const auto shapeAt = [&](QPoint pixel) {
    QTest::mouseMove(window.view(), pixel);
    return window.view()->cursor().shape();
  };
  const QPoint beside = window.view()->rect().center();
  const Qt::CursorShape usual = shapeAt(beside);
  QCOMPARE(shapeAt(window.pixelOf(1.5)), Qt::OpenHandCursor);
  QCOMPARE(shapeAt(window.pixelOf(1.2)), Qt::SizeHorCursor);
  QCOMPARE(shapeAt(window.pixelOf(1.8)), Qt::SizeHorCursor);
  QCOMPARE(shapeAt(beside), usual);
  QVERIFY(usual != Qt::OpenHandCursor && usual != Qt::SizeHorCursor);
}

void TargetWindowTest::aDoubleClickOnItLeavesTheView() {
  Window window;
  window.press(Qt::Key_G);
  const double whole = window.view()->camera().scale();
  window.view()->zoomIn();
  const QPoint middle = window.view()->rect().center();
  window.hand.drag(middle, middle - QPoint(0, window.view()->height() / 4));
  const ui::Camera before = window.view()->camera();
  const QPoint target = window.pixelOf(window.aim()->place().center);
  QVERIFY(window.view()->rect().contains(target));
  QTest::mouseDClick(window.view(), Qt::LeftButton, {}, target);
  QVERIFY(window.view()->camera() == before);
  // Elsewhere it shows the whole room.
  QTest::mouseDClick(window.view(), Qt::LeftButton, {}, middle);
  QCOMPARE(window.view()->camera().scale(), whole);
}

void TargetWindowTest::besideItTheMouseMovesTheView() {
  Window window;
  window.press(Qt::Key_G);
  window.view()->zoomIn();
  const core::Target place = window.aim()->place();
  const ui::Camera before = window.view()->camera();
  const QPoint middle = window.view()->rect().center();
  window.hand.drag(middle, middle + QPoint(40, 30));
  QCOMPARE(window.aim()->place(), place);
  QVERIFY(!(window.view()->camera() == before));
}

void TargetWindowTest::staysInTheRoom() {
  Window window;
  window.press(Qt::Key_G);
  window.hand.drag(window.pixelOf(window.aim()->place().center), window.pixelOf(20));
  QCOMPARE(window.aim()->place().center, 3.0);
  window.hand.drag(window.pixelOf(2.97), window.pixelOf(-20));
  QCOMPARE(window.aim()->place().center, 0.0);
}

void TargetWindowTest::saysWhenTheWeightHitIt() {
  Window window;
  window.press(Qt::Key_G);
  window.aim()->setPlace({1.1, 0.3});
  window.controller()->goTo(landingTime() - 0.1);
  QVERIFY(!window.view()->target()->landings[0]);
  window.controller()->goTo(2);
  const auto landing = window.view()->target()->landings[0];
  QVERIFY(landing);
  QVERIFY(std::abs(landing->time - landingTime()) < 1e-9);
  QVERIFY(std::abs(landing->place - 1) < 1e-12);
  // Euler's falls take longer by about half its step.
  const auto other = window.view()->target()->landings[1];
  QVERIFY(other && std::abs(other->time - landingTime()) > 1e-3);
}

void TargetWindowTest::followsTheSelectedWeight() {
  Window window;
  window.press(Qt::Key_G);
  window.controller()->goTo(2);
  window.selection()->select(1);
  QCOMPARE(window.aim()->weight(), 1);
  QVERIFY(std::abs(window.view()->target()->landings[0]->place - 2) < 1e-12);
  window.selection()->clear();
  QCOMPARE(window.aim()->weight(), 1);
}

void TargetWindowTest::goingBackTakesTheLandingBack() {
  Window window;
  window.press(Qt::Key_G);
  window.controller()->goTo(2);
  QVERIFY(window.view()->target()->landings[0]);
  window.press(Qt::Key_Home);
  QVERIFY(!window.view()->target()->landings[0]);
  window.controller()->reset();
  QCOMPARE(window.view()->target()->landings.size(), std::size_t{2});
}

void TargetWindowTest::countsOnlyLandingsAfterTheCut() {
  Window window;
  window.press(Qt::Key_G);
  window.editor()->change([](core::Scene& scene) {
    scene.cutTime = 1;
    scene.weights[0].rope.reset();  // falls at once, and is on the floor long before the cut
    scene.weights[0].position = {1, 0.3};
    scene.room.restitution = 1;
  });
  window.controller()->goTo(0.9);
  QVERIFY(!window.view()->target()->landings[0]);
  window.controller()->goTo(2);
  QVERIFY(window.view()->target()->landings[0]->time > 1);
}

void TargetWindowTest::eachSplitViewShowsItsOwnRun() {
  Window window;
  window.press(Qt::Key_G);
  window.controller()->goTo(2);
  const auto both = window.view()->target()->landings;
  window.press(Qt::Key_V);
  const auto& views = window.area()->views();
  QCOMPARE(views.size(), std::size_t{2});
  for (std::size_t i = 0; i < 2; ++i) {
    QCOMPARE(views[i]->target()->landings.size(), std::size_t{1});
    QCOMPARE(views[i]->target()->landings[0]->time, both[i]->time);
  }
}

void TargetWindowTest::isFoundInAnotherScenesRoom() {
  Window window;
  window.press(Qt::Key_G);
  window.aim()->setPlace({2.9, 0.1});
  window.selection()->select(1);
  window.editor()->change([](core::Scene& scene) {
    scene.weights.resize(1);
    scene.room.width = 2;
  });
  QVERIFY(window.aim()->place().center <= 2);
  QCOMPARE(window.aim()->weight(), 0);
  QVERIFY(window.view()->target());
}

void TargetWindowTest::isInExportedPictures_data() {
  QTest::addColumn<double>("center");
  QTest::addColumn<QByteArray>("words");
  QTest::newRow("hit") << 1.1 << QByteArray("Hit at 1.049 s");
  QTest::newRow("missed") << 1.5 << QByteArray("Missed by 0.350 m at 1.049 s");
}

void TargetWindowTest::isInExportedPictures() {
  QFETCH(double, center);
  QFETCH(QByteArray, words);
  Window window;
  const QString file = m_folder.filePath("scene.svg");
  window.controller()->goTo(2);
  window.exports()->savePicture(file);
  QVERIFY(!contentOf(file).contains(words));
  window.press(Qt::Key_G);
  window.aim()->setPlace({center, 0.3});
  window.exports()->savePicture(file);
  QVERIFY(contentOf(file).contains(words));
}

QTEST_MAIN(TargetWindowTest)
#include "target_window_test.moc"
