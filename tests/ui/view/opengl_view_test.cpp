#include <QLabel>
#include <QMainWindow>
#include <QOpenGLWidget>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/run/run.h"
#include "tests/ui/view/image_difference.h"
#include "ui/control/run_controller.h"
#include "ui/control/settings.h"
#include "ui/main_window.h"
#include "ui/view/opengl_probe.h"
#include "ui/view/scene_canvas.h"
#include "ui/view/scene_view.h"

class OpenGlViewTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void drawsTheSameWithBothPainters();
  void prefersQPainterToSoftwareOpenGl();
  void survivesAnotherWindow();
  void switchesWhileShown();
  void goesOnWithQPainterWhereOpenGlIsLost();

 private:
  QTemporaryDir m_folder;  // for settings

  static std::unique_ptr<core::Run> swing() {
    core::Scene scene;
    for (int i = 0; i < 3; ++i) {
      core::Weight weight;
      weight.radius = 0.05;
      weight.rope = core::Rope{{1.0 + i, 2.8}, 1.2, 0.7, 0, false};
      scene.weights.push_back(weight);
    }
    auto run = std::make_unique<core::Run>(std::make_shared<const core::Scene>(scene),
                                           core::Solver{"rk4", 1.0 / 60});
    return run;
  }

  static QImage picture(ui::SceneView& view) {
    return view.grab().toImage().convertToFormat(QImage::Format_RGB32);
  }

  static void show(QWidget& window) {
    window.resize(800, 600);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
  }
};

void OpenGlViewTest::initTestCase() {
  QVERIFY2(ui::probeOpenGl().usable, "these tests need OpenGL 3.3");
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void OpenGlViewTest::drawsTheSameWithBothPainters() {
  const std::unique_ptr<core::Run> run = swing();
  ui::SceneView view;
  view.setRuns({run.get()});
  for (int i = 0; i < 20; ++i) {
    run->advance();
    view.showTime(run->time());
  }
  view.setPainterChoice(ui::PainterChoice::kOpenGl);
  QVERIFY(view.painterDescription().startsWith("OpenGL "));
  show(view);
  const QImage openGl = picture(view);
  view.setPainterChoice(ui::PainterChoice::kQPainter);
  const QImage qPainter = picture(view);
  QCOMPARE(openGl.size(), qPainter.size());
  const ImageDifference difference = differenceOf(openGl, qPainter);
  // As in opengl_renderer_test; words besides, whose letters OpenGL places on whole pixels and
  // smooths in its own way: under a hundredth of the picture.
  QVERIFY2(difference.mean < 0.6, qPrintable(difference.inWords()));
  QVERIFY2(difference.shareApart < 6e-3, qPrintable(difference.inWords()));
}

void OpenGlViewTest::prefersQPainterToSoftwareOpenGl() {
  ui::SceneView view;
  const bool software = ui::probeOpenGl().software;
  QCOMPARE(view.painterDescription() == "QPainter (software OpenGL would be slower)", software);
}

void OpenGlViewTest::survivesAnotherWindow() {
  const std::unique_ptr<core::Run> run = swing();
  QMainWindow first;
  QMainWindow second;
  auto* view = new ui::SceneView(&first);
  view->setPainterChoice(ui::PainterChoice::kOpenGl);
  view->setRuns({run.get()});
  first.setCentralWidget(view);
  show(first);
  const QImage before = picture(*view);
  second.setCentralWidget(first.takeCentralWidget());
  show(second);
  run->advance();
  view->showTime(0);
  QCOMPARE(picture(*view), before);
  QVERIFY(view->painterDescription().startsWith("OpenGL "));
}

void OpenGlViewTest::switchesWhileShown() {
  const std::unique_ptr<core::Run> run = swing();
  QMainWindow window;
  auto* view = new ui::SceneView(&window);
  view->setPainterChoice(ui::PainterChoice::kQPainter);
  view->setRuns({run.get()});
  window.setCentralWidget(view);
  show(window);
  const QImage before = picture(*view);
  QSignalSpy changed(view, &ui::SceneView::painterChanged);
  view->setPainterChoice(ui::PainterChoice::kOpenGl);
  QTRY_COMPARE(view->findChildren<QOpenGLWidget*>().size(), 1);
  QVERIFY(QTest::qWaitForWindowExposed(&window));
  const ImageDifference difference = differenceOf(picture(*view), before);
  // As in drawsTheSameWithBothPainters.
  QVERIFY2(difference.mean < 0.6, qPrintable(difference.inWords()));
  view->setPainterChoice(ui::PainterChoice::kQPainter);
  QTRY_COMPARE(view->findChildren<QOpenGLWidget*>().size(), 0);
  QCOMPARE(changed.count(), 2);
}

void OpenGlViewTest::goesOnWithQPainterWhereOpenGlIsLost() {
  ui::Settings().setPainter(ui::PainterChoice::kOpenGl);
  core::Scene scene = swing()->scene();
  scene.solvers = {{.method = "rk4"}, {.method = "euler"}};
  ui::MainWindow window(scene);
  show(window);
  auto* view = window.findChild<ui::SceneView*>();
  const auto* painter = window.findChild<QLabel*>("painter");
  QVERIFY(painter->text().contains("OpenGL "));
  const QImage before = picture(*view);
  // As OpenGL does when the driver has reset it, in the middle of painting.
  auto* canvas = view->findChild<ui::OpenGlCanvas*>();
  QVERIFY(canvas);
  emit canvas->failed();
  QTRY_COMPARE(view->findChildren<QOpenGLWidget*>().size(), 0);
  QCOMPARE(painter->text(), "Drawn by QPainter (OpenGL was lost)");
  const ImageDifference difference = differenceOf(picture(*view), before);
  // As in drawsTheSameWithBothPainters, but words fill more of so small a view.
  QVERIFY2(difference.shareApart < 0.03, qPrintable(difference.inWords()));
  window.controller()->setStopwatch([] { return 0.0; });
  window.controller()->play();
  window.controller()->passTime(0.1);
  QVERIFY(differenceOf(picture(*view), before).shareApart > 1e-4);
  ui::Settings().setPainter(ui::PainterChoice::kAutomatic);
}

QTEST_MAIN(OpenGlViewTest)
#include "opengl_view_test.moc"
