#include "ui/view/scene_canvas.h"

#include <utility>

#include <QOpenGLContext>
#include <QPainter>

#include "ui/view/opengl_probe.h"
#include "ui/view/opengl_renderer.h"
#include "ui/view/qpainter_renderer.h"

namespace ui {

PainterCanvas::PainterCanvas(FrameSource source, QWidget* parent)
    : QWidget(parent), m_source(std::move(source)) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAttribute(Qt::WA_TransparentForMouseEvents);
}

void PainterCanvas::paintEvent(QPaintEvent*) {
  const Frame frame = m_source(size(), devicePixelRatioF());
  const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
  if (m_image.size() != pixels) m_image = QImage(pixels, QImage::Format_RGB32);
  m_image.setDevicePixelRatio(1);
  paintDrawing(frame.drawing, frame.camera, m_image);
  m_image.setDevicePixelRatio(devicePixelRatioF());
  QPainter(this).drawImage(0, 0, m_image);
}

OpenGlCanvas::OpenGlCanvas(FrameSource source, QWidget* parent)
    : QOpenGLWidget(parent), m_source(std::move(source)) {
  setFormat(sceneSurfaceFormat());
  setAttribute(Qt::WA_TransparentForMouseEvents);
}

OpenGlCanvas::~OpenGlCanvas() {
  // The context goes after this object's own members are gone.
  disconnect(m_contextConnection);
  releaseRenderer();
}

bool OpenGlCanvas::isLost() const {
  return m_renderer && !isValid();
}

void OpenGlCanvas::releaseRenderer() {
  if (!m_renderer) return;
  makeCurrent();
  m_renderer.reset();
  doneCurrent();
}

void OpenGlCanvas::paintEvent(QPaintEvent* event) {
  QOpenGLWidget::paintEvent(event);
  if (isLost()) emit failed();
}

void OpenGlCanvas::initializeGL() {
  disconnect(m_contextConnection);
  m_contextConnection =
      connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &OpenGlCanvas::releaseRenderer);
  m_renderer = OpenGlRenderer::create();
  if (!m_renderer) emit failed();
}

void OpenGlCanvas::paintGL() {
  if (!m_renderer) return;
  const Frame frame = m_source(size(), devicePixelRatioF());
  m_renderer->paint(frame.drawing, frame.camera);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintTexts(frame.drawing.texts, frame.camera, painter);
}

}  // namespace ui
