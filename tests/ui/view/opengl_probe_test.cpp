#include "ui/view/opengl_probe.h"

#include <QGuiApplication>
#include <QTest>

class OpenGlProbeTest : public QObject {
  Q_OBJECT

 private slots:
  void refusesPlatformsWithoutWindows() {
    QCOMPARE(QGuiApplication::platformName(), "offscreen");
    QVERIFY(!ui::probeOpenGl().usable);
  }
};

QTEST_MAIN(OpenGlProbeTest)
#include "opengl_probe_test.moc"
