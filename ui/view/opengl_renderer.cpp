#include "ui/view/opengl_renderer.h"

#include <cstddef>

#include <QColor>
#include <QOpenGLContext>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLVersionFunctionsFactory>

#include "ui/view/camera.h"
#include "ui/view/drawing.h"

// Resources of a static library are only linked in when they are asked for, outside of any
// namespace.
static void initializeShaderResources() {
  Q_INIT_RESOURCE(shaders);
}

namespace ui {

std::unique_ptr<OpenGlRenderer> OpenGlRenderer::create() {
  std::unique_ptr<OpenGlRenderer> renderer(new OpenGlRenderer);
  if (!renderer->initialize()) return nullptr;
  return renderer;
}

OpenGlRenderer::~OpenGlRenderer() = default;

bool OpenGlRenderer::initialize() {
  initializeShaderResources();
  QOpenGLContext* context = QOpenGLContext::currentContext();
  if (!context) return false;
  m_functions = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(context);
  if (!m_functions || !m_functions->initializeOpenGLFunctions()) return false;
  const QString folder = QStringLiteral(":/shaders/shape");
  if (!m_program.addShaderFromSourceFile(QOpenGLShader::Vertex, folder + ".vert")) return false;
  if (!m_program.addShaderFromSourceFile(QOpenGLShader::Fragment, folder + ".frag")) return false;
  if (!m_program.link() || !m_vertexArray.create() || !m_buffer.create()) return false;
  m_buffer.setUsagePattern(QOpenGLBuffer::StreamDraw);
  describeShapes();
  return true;
}

void OpenGlRenderer::describeShapes() {
  m_vertexArray.bind();
  m_buffer.bind();
  const auto describe = [this](GLuint location, GLenum type, std::size_t offset) {
    m_functions->glEnableVertexAttribArray(location);
    m_functions->glVertexAttribPointer(location, 4, type, type == GL_UNSIGNED_BYTE, sizeof(Shape),
                                       reinterpret_cast<const void*>(offset));
    m_functions->glVertexAttribDivisor(location, 1);
  };
  describe(0, GL_FLOAT, offsetof(Shape, from));
  describe(1, GL_FLOAT, offsetof(Shape, fromEdge));
  describe(2, GL_FLOAT, offsetof(Shape, fromHalfWidth));
  describe(3, GL_UNSIGNED_BYTE, offsetof(Shape, color));
  describe(4, GL_UNSIGNED_BYTE, offsetof(Shape, outline));
  m_buffer.release();
  m_vertexArray.release();
}

void OpenGlRenderer::upload() {
  m_buffer.allocate(m_shapes.data(), static_cast<int>(m_shapes.size() * sizeof(Shape)));
  ++m_work.uploads;
}

void OpenGlRenderer::draw() {
  m_functions->glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4,
                                     static_cast<GLsizei>(m_shapes.size()));
  ++m_work.drawCalls;
  m_work.shapes += static_cast<std::int64_t>(m_shapes.size());
}

void OpenGlRenderer::paint(const Drawing& drawing, const Camera& camera) {
  m_shapes.clear();
  for (const Layer& layer : drawing.layers) {
    addRectangles(layer, camera, m_shapes);
    addShapes(layer, camera, m_shapes);
  }
  const QColor background = QColor::fromRgb(drawing.background);
  const QSizeF size = camera.viewport() * camera.devicePixelRatio();
  m_functions->glClearColor(background.redF(), background.greenF(), background.blueF(), 1);
  m_functions->glClear(GL_COLOR_BUFFER_BIT);
  m_functions->glEnable(GL_BLEND);
  m_functions->glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

  m_program.bind();
  m_program.setUniformValue("viewport", size);
  m_vertexArray.bind();
  m_buffer.bind();
  upload();
  draw();
  m_buffer.release();
  m_vertexArray.release();
  m_program.release();
  m_functions->glDisable(GL_BLEND);
}

}  // namespace ui
