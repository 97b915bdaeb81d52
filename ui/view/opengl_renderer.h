#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <QOpenGLBuffer>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>

#include "ui/view/shape.h"

class QOpenGLFunctions_3_3_Core;

namespace ui {

class Camera;
struct Drawing;

/// Paints the shapes of a drawing with OpenGL 3.3: one upload and one call for all of them.
/// Words are left to paintTexts().
///
/// Belongs to the context that was current when it was made; make that current again before
/// painting and before destroying it.
class OpenGlRenderer {
 public:
  /// @return  null where the context cannot run it
  static std::unique_ptr<OpenGlRenderer> create();
  ~OpenGlRenderer();

  /// Fills the bound framebuffer, which is as large as the camera's viewport in device pixels.
  void paint(const Drawing& drawing, const Camera& camera);

  /// What has been asked of OpenGL since the renderer was made.
  struct Work {
    int uploads = 0;
    int drawCalls = 0;
    std::int64_t shapes = 0;
  };
  const Work& work() const { return m_work; }

 private:
  OpenGlRenderer() = default;
  bool initialize();
  void describeShapes();
  void upload();
  void draw();

  QOpenGLFunctions_3_3_Core* m_functions = nullptr;  // the context's
  QOpenGLShaderProgram m_program;
  QOpenGLVertexArrayObject m_vertexArray;
  QOpenGLBuffer m_buffer;
  std::vector<Shape> m_shapes;  // of the last frame, for its memory
  Work m_work;
};

}  // namespace ui
