#include "ui/view/qpainter_renderer.h"

#include <QImage>
#include <QPainter>
#include <QTest>

#include "tests/ui/view/example_scenes.h"
#include "tests/ui/view/image_difference.h"

class QPainterRendererTest : public QObject {
  Q_OBJECT

 private slots:
  void paintsWeightsWhereTheyAre_data();
  void paintsWeightsWhereTheyAre();
  void imagesLookLikeVectorPictures_data();
  void imagesLookLikeVectorPictures();
  void paintsArrowsThatPointToTheirTip();
  void gridLinesAreCrisp();

 private:
  static QImage imageOf(const ui::Drawing& drawing, const ui::Camera& camera) {
    QImage image((camera.viewport() * camera.devicePixelRatio()).toSize(), QImage::Format_RGB32);
    ui::paintDrawing(drawing, camera, image);
    return image;
  }

  static QImage vectorImageOf(const ui::Drawing& drawing, const ui::Camera& camera) {
    QImage image((camera.viewport() * camera.devicePixelRatio()).toSize(), QImage::Format_RGB32);
    QPainter painter(&image);
    painter.scale(camera.devicePixelRatio(), camera.devicePixelRatio());
    ui::paintDrawing(drawing, camera, painter);
    return image;
  }
};

void QPainterRendererTest::paintsWeightsWhereTheyAre_data() {
  QTest::addColumn<double>("ratio");
  QTest::newRow("one device pixel a pixel") << 1.0;
  QTest::newRow("two") << 2.0;
}

void QPainterRendererTest::paintsWeightsWhereTheyAre() {
  QFETCH(double, ratio);
  const ui::ShownScene shown = example::freeWeights(3, 0.05, 0.5);
  const ui::Camera camera = example::camera(shown, {800, 600}, ratio);
  const ui::SceneLook look = example::look();
  const QImage image = imageOf(ui::sceneDrawing(shown, ui::Trails(), camera, look), camera);
  const auto colorAt = [&](const Eigen::Vector2d& place) {
    return image.pixel((camera.toPixels(place) * ratio).toPoint());
  };
  for (const core::WeightState& weight : shown.runs[0].weights)
    QCOMPARE(colorAt(weight.position), shown.colors[0]);
  // The second run's weights are empty inside but for the line that joins them to the first.
  for (const core::WeightState& weight : shown.runs[1].weights) {
    const Eigen::Vector2d edge(0, 0.05 + 1 / camera.scale());
    QCOMPARE(colorAt(weight.position + edge), look.theme.runs[1].rgb());
    QVERIFY(colorAt(weight.position + edge / 2) != look.theme.runs[1].rgb());
  }
}

void QPainterRendererTest::imagesLookLikeVectorPictures_data() {
  QTest::addColumn<bool>("dark");
  QTest::addColumn<double>("ratio");
  QTest::newRow("light") << false << 1.0;
  QTest::newRow("dark") << true << 1.0;
  QTest::newRow("light, fine") << false << 2.0;
}

void QPainterRendererTest::imagesLookLikeVectorPictures() {
  QFETCH(bool, dark);
  QFETCH(double, ratio);
  ui::Trails trails;
  const ui::ShownScene shown = example::marked(example::everything(trails));
  const ui::Camera camera = example::camera(shown, {800, 600}, ratio);
  const ui::Drawing drawing = ui::sceneDrawing(shown, trails, camera, example::look(dark));
  const ImageDifference difference =
      differenceOf(imageOf(drawing, camera), vectorImageOf(drawing, camera));
  // Edges are antialiased by two formulas, and trails fade in steps: half a gray level on the
  // whole, and hardly a pixel that differs by much.
  QVERIFY2(difference.mean < 0.5, qPrintable(difference.inWords()));
  QVERIFY2(difference.shareApart < 1e-3, qPrintable(difference.inWords()));
}

void QPainterRendererTest::paintsArrowsThatPointToTheirTip() {
  ui::Camera camera;
  camera.setViewport({100, 100});
  camera.fit({100, 100}, {});
  ui::Drawing drawing;
  drawing.layers[ui::kFrontLayer].arrows.push_back({{10, 50}, {90, 50}, 4, 0xff000000});
  for (const QImage& image : {imageOf(drawing, camera), vectorImageOf(drawing, camera)}) {
    QCOMPARE(image.pixel(40, 50), 0xff000000);  // shaft
    QCOMPARE(image.pixel(40, 55), 0xffffffff);  // beside the shaft
    QCOMPARE(image.pixel(76, 54), 0xff000000);  // head, wider than the shaft
    QCOMPARE(image.pixel(88, 54), 0xffffffff);  // beside the head, which has narrowed there
    QCOMPARE(image.pixel(92, 50), 0xffffffff);  // beyond the tip
  }
}

void QPainterRendererTest::gridLinesAreCrisp() {
  const ui::ShownScene shown = example::freeWeights(0, 0.02, 0);
  const ui::Camera camera = example::camera(shown);
  const ui::SceneLook look = example::look();
  const QImage image = imageOf(ui::sceneDrawing(shown, ui::Trails(), camera, look), camera);
  // Where the grid crosses a row of pixels, one pixel has its full color, those beside have none.
  const int y = qRound(camera.toPixels({0, 0.77}).y());
  const int x = qRound(camera.toPixels({2, 0}).x());
  int lines = 0;
  for (int i = x - 2; i <= x + 2; ++i) lines += image.pixel(i, y) == look.theme.grid.rgb() ? 1 : 0;
  QCOMPARE(lines, 1);
  for (int i = x - 2; i <= x + 2; ++i)
    QVERIFY(image.pixel(i, y) == look.theme.grid.rgb() ||
            image.pixel(i, y) == look.theme.room.rgb());
}

QTEST_MAIN(QPainterRendererTest)
#include "qpainter_renderer_test.moc"
