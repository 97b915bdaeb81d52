#include <QGuiApplication>
#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "core/run/run.h"
#include "tests/ui/view/image_difference.h"
#include "ui/control/run_controller.h"
#include "ui/main_window.h"
#include "ui/view/opengl_probe.h"
#include "ui/view/scene_view.h"

class OpenGlMissingTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
  }

  void probeRefusesAnOpenGlThatIsTooOld() {
    QCOMPARE(QGuiApplication::platformName(), "xcb");
    QVERIFY(!ui::probeOpenGl().usable);
  }

  void viewDrawsWithQPainterEvenWhenOpenGlIsAskedFor() {
    core::Scene scene;
    scene.weights.resize(1);
    scene.weights[0].position = {2, 1};
    const core::Run run(std::make_shared<const core::Scene>(scene), core::Solver());
    ui::SceneView view;
    view.setPainterChoice(ui::PainterChoice::kOpenGl);
    view.setRuns({&run});
    view.resize(800, 600);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    QCOMPARE(view.painterDescription(), "QPainter (no OpenGL 3.3)");
    // The ground of the room, seen between grid lines.
    const QRgb room = ui::Theme::of(view.palette()).room.rgb();
    QVERIFY(shareOf(room, view.grab().toImage()) > 0.3);
  }

  void windowSaysSoAndPlays() {
    core::Scene scene;
    scene.weights.resize(1);
    scene.weights[0].position = {2, 1};
    scene.solvers = {{.method = "rk4"}};
    ui::MainWindow window(scene);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QCOMPARE(window.findChild<QLabel*>("painter")->text(), "Drawn by QPainter (no OpenGL 3.3)");
    window.controller()->setStopwatch([] { return 0.0; });
    const QImage before = window.findChild<ui::SceneView*>()->grab().toImage();
    window.controller()->play();
    window.controller()->passTime(0.1);
    QVERIFY(window.findChild<ui::SceneView*>()->grab().toImage() != before);
  }

 private:
  QTemporaryDir m_folder;  // for settings
};

QTEST_MAIN(OpenGlMissingTest)
#include "opengl_missing_test.moc"
