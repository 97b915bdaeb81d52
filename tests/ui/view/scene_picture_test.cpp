#include "ui/view/scene_picture.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>

#include "core/run/run.h"
#include "ui/view/trails.h"

class ScenePictureTest : public QObject {
  Q_OBJECT

 private slots:
  void pngHasTwiceTheSizeAndSaysHowLargeItIs();
  void svgHasTheSizeAndTellsSceneTimeAndMethods();
  void pdfHasOnePageOfTheSize();
  void trailsAreDrawnWhenGiven();
  void refusesOtherEndings();
  void leavesNothingBehindWhereItCannotWrite();
  void replacesAnOlderPicture();

 private:
  QString path(const char* name) const { return m_folder.filePath(name); }

  static std::shared_ptr<const core::Scene> twoWeights() {
    core::Scene scene;
    scene.name = "Two weights";
    scene.weights.resize(2);
    scene.weights[0].position = {1, 2};
    scene.weights[1].position = {3, 2};
    return std::make_shared<const core::Scene>(scene);
  }

  static std::vector<core::Run> startedRuns() {
    std::vector<core::Run> runs;
    for (const char* method : {"rk4", "euler"}) {
      runs.emplace_back(twoWeights(), core::Solver{method, 1.0 / 60});
      for (int i = 0; i < 15; ++i) runs.back().advance();
    }
    return runs;
  }

  QString write(const QString& file, const ui::PicturedMarks& pictured = {}) const {
    const std::vector<core::Run> runs = startedRuns();
    return ui::writeScenePicture(file, {&runs[0], &runs[1]}, runs[0].time(), QSize(600, 450),
                                 pictured);
  }

  static QByteArray contentOf(const QString& file) {
    QFile opened(file);
    return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
  }

  QTemporaryDir m_folder;
};

void ScenePictureTest::pngHasTwiceTheSizeAndSaysHowLargeItIs() {
  QCOMPARE(write(path("scene.png")), QString());
  const QImage image(path("scene.png"));
  QCOMPARE(image.size(), QSize(1200, 900));
  QCOMPARE(qRound(image.dotsPerMeterX() * 0.0254), 192);
}

void ScenePictureTest::svgHasTheSizeAndTellsSceneTimeAndMethods() {
  QCOMPARE(write(path("scene.svg")), QString());
  QSvgRenderer svg(path("scene.svg"));
  QVERIFY(svg.isValid());
  QCOMPARE(svg.viewBoxF(), QRectF(0, 0, 600, 450));
  const QString content = QString::fromUtf8(contentOf(path("scene.svg")));
  for (const char* words : {"Two weights", "t = 0.250 s", "Runge–Kutta 4, 1/60 s", "Euler"})
    QVERIFY2(content.contains(QString::fromUtf8(words)), words);
}

void ScenePictureTest::pdfHasOnePageOfTheSize() {
  QCOMPARE(write(path("scene.pdf")), QString());
  const QByteArray content = contentOf(path("scene.pdf"));
  QVERIFY(content.startsWith("%PDF-"));
  QVERIFY(content.contains("/Count 1"));
  // 600 × 450 px at 96 dpi in points, 72 an inch.
  QVERIFY(content.contains("/MediaBox [0 0 450.") || content.contains("/MediaBox [0 0 450 "));
}

void ScenePictureTest::trailsAreDrawnWhenGiven() {
  ui::Trails trails;
  trails.reset(2, 2, 2);
  std::vector<ui::ShownRun> runs(2);
  for (const double height : {2.5, 2.2, 1.9}) {
    for (ui::ShownRun& run : runs) {
      run.weights.assign(2, {});
      for (core::WeightState& weight : run.weights) weight.position = {1, height};
    }
    trails.record(3 - height, runs);
  }
  QCOMPARE(write(path("without.png")), QString());
  QCOMPARE(write(path("with.png"), {.trails = &trails}), QString());
  QVERIFY(QImage(path("without.png")) != QImage(path("with.png")));
}

void ScenePictureTest::refusesOtherEndings() {
  for (const char* name : {"scene.jpeg", "scene", "png"}) {
    QVERIFY(write(path(name)).contains(".png, .svg or .pdf"));
    QVERIFY(!QFile::exists(path(name)));
  }
}

void ScenePictureTest::leavesNothingBehindWhereItCannotWrite() {
  QCOMPARE(write(path("missing/scene.png")), QString("No such file or directory"));
  QVERIFY(!QDir(path("missing")).exists());
}

void ScenePictureTest::replacesAnOlderPicture() {
  QFile old(path("old.svg"));
  QVERIFY(old.open(QIODevice::WriteOnly));
  old.write("old");
  old.close();
  QCOMPARE(write(path("old.svg")), QString());
  QVERIFY(QSvgRenderer(path("old.svg")).isValid());
}

QTEST_MAIN(ScenePictureTest)
#include "scene_picture_test.moc"
