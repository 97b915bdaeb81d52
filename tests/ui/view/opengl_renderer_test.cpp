#include "ui/view/opengl_renderer.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLVersionFunctionsFactory>
#include <QTest>

#include "tests/ui/view/example_scenes.h"
#include "tests/ui/view/image_difference.h"
#include "ui/view/opengl_probe.h"
#include "ui/view/qpainter_renderer.h"

class OpenGlRendererTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void looksLikeTheOtherPainter_data();
  void looksLikeTheOtherPainter();
  void paintsManyFramesOfAnyLength();
  void paintsAHundredThousandWeightsInOneCall();

 private:
  QImage imageOf(const ui::Drawing& drawing, const ui::Camera& camera);

  QOpenGLContext m_context;
  QOffscreenSurface m_surface;
};

void OpenGlRendererTest::initTestCase() {
  QVERIFY2(ui::probeOpenGl().usable, "these tests need OpenGL 3.3");
  m_context.setFormat(ui::sceneSurfaceFormat());
  QVERIFY(m_context.create());
  m_surface.setFormat(m_context.format());
  m_surface.create();
  QVERIFY(m_context.makeCurrent(&m_surface));
}

QImage OpenGlRendererTest::imageOf(const ui::Drawing& drawing, const ui::Camera& camera) {
  const QSize size = (camera.viewport() * camera.devicePixelRatio()).toSize();
  QOpenGLFramebufferObject target(size);
  target.bind();
  m_context.functions()->glViewport(0, 0, size.width(), size.height());
  ui::OpenGlRenderer::create()->paint(drawing, camera);
  QImage image = target.toImage().convertToFormat(QImage::Format_RGB32);
  target.release();
  return image;
}

void OpenGlRendererTest::looksLikeTheOtherPainter_data() {
  QTest::addColumn<bool>("dark");
  QTest::addColumn<double>("ratio");
  QTest::addColumn<double>("zoom");
  QTest::newRow("light") << false << 1.0 << 1.0;
  QTest::newRow("dark") << true << 1.0 << 1.0;
  QTest::newRow("fine") << false << 2.0 << 1.0;
  QTest::newRow("close") << true << 1.0 << 7.0;
  QTest::newRow("from afar") << false << 1.0 << 0.3;
}

void OpenGlRendererTest::looksLikeTheOtherPainter() {
  QFETCH(bool, dark);
  QFETCH(double, ratio);
  QFETCH(double, zoom);
  ui::Trails trails;
  const ui::ShownScene shown = example::marked(example::everything(trails));
  ui::Camera camera = example::camera(shown, {800, 600}, ratio);
  camera.zoomAt(camera.toPixels({0.6, 1.1}), zoom);
  ui::Drawing drawing = ui::sceneDrawing(shown, trails, camera, example::look(dark));
  drawing.texts.clear();
  drawing.layers[ui::kFrontLayer].arrows.push_back({{1, 1}, {2, 1.7}, 3, 0xffd55e00});

  QImage expected((camera.viewport() * ratio).toSize(), QImage::Format_RGB32);
  ui::paintDrawing(drawing, camera, expected);
  const ImageDifference difference = differenceOf(imageOf(drawing, camera), expected);
  // One formula, computed twice: colors round differently, and at the edges between joined
  // strokes a pixel may fall to the one or the other.
  QVERIFY2(difference.mean < 0.1, qPrintable(difference.inWords()));
  QVERIFY2(difference.shareApart < 2e-4, qPrintable(difference.inWords()));
}

void OpenGlRendererTest::paintsManyFramesOfAnyLength() {
  const std::unique_ptr<ui::OpenGlRenderer> renderer = ui::OpenGlRenderer::create();
  QOpenGLFramebufferObject target(800, 600);
  target.bind();
  for (const int count : {0, 1000, 1, 5000}) {
    const ui::ShownScene shown = example::freeWeights(count, 0.02, 0.1);
    const ui::Camera camera = example::camera(shown);
    renderer->paint(ui::sceneDrawing(shown, ui::Trails(), camera, example::look()), camera);
  }
  QCOMPARE(m_context.functions()->glGetError(), GLenum(GL_NO_ERROR));
}

void OpenGlRendererTest::paintsAHundredThousandWeightsInOneCall() {
  constexpr int kWeights = 100000;
  const std::unique_ptr<ui::OpenGlRenderer> renderer = ui::OpenGlRenderer::create();
  QOpenGLFramebufferObject target(80, 60);
  target.bind();
  const ui::ShownScene shown = example::freeWeights(kWeights, 0.02, 0.1);
  const ui::Camera camera = example::camera(shown, {80, 60});
  const ui::Drawing drawing = ui::sceneDrawing(shown, ui::Trails(), camera, example::look());
  // OpenGL's own count of triangles: two for each shape.
  auto* functions = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(&m_context);
  GLuint query = 0;
  functions->glGenQueries(1, &query);
  functions->glBeginQuery(GL_PRIMITIVES_GENERATED, query);
  for (int frame = 1; frame <= 2; ++frame) {
    renderer->paint(drawing, camera);
    QCOMPARE(renderer->work().uploads, frame);
    QCOMPARE(renderer->work().drawCalls, frame);
  }
  functions->glEndQuery(GL_PRIMITIVES_GENERATED);
  GLuint triangles = 0;
  functions->glGetQueryObjectuiv(query, GL_QUERY_RESULT, &triangles);
  functions->glDeleteQueries(1, &query);
  QVERIFY(renderer->work().shapes >= 2 * kWeights);
  QCOMPARE(static_cast<std::int64_t>(triangles), 2 * renderer->work().shapes);
}

QTEST_MAIN(OpenGlRendererTest)
#include "opengl_renderer_test.moc"
