#include <QGuiApplication>
#include <QTest>

#include "core/run/run.h"
#include "ui/view/opengl_probe.h"
#include "ui/view/scene_view.h"

class OpenGlMissingTest : public QObject {
  Q_OBJECT

 private slots:
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
    QCOMPARE(view.grab().toImage().pixel(400, 250), ui::Theme::of(view.palette()).room.rgb());
  }
};

QTEST_MAIN(OpenGlMissingTest)
#include "opengl_missing_test.moc"
