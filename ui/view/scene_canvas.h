#pragma once

#include <functional>
#include <memory>

#include <QImage>
#include <QOpenGLWidget>
#include <QWidget>

#include "ui/view/camera.h"
#include "ui/view/drawing.h"

namespace ui {

class OpenGlRenderer;

/// What a canvas shows in one frame.
struct Frame {
  Camera camera;
  Drawing drawing;
};

/// Makes the frame for a canvas of this size [logical px] and ratio of device pixels to them.
using FrameSource = std::function<Frame(QSize size, double devicePixelRatio)>;

// Canvases fill a SceneView, which gets their mouse events.

/// Shows frames painted by the processor.
class PainterCanvas : public QWidget {
  Q_OBJECT

 public:
  PainterCanvas(FrameSource source, QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  FrameSource m_source;
  QImage m_image;
};

/// Shows frames painted by OpenGL. Lives on when its context is replaced, as when the window it
/// stands in becomes another one.
/// @pre probeOpenGl() found OpenGL usable
class OpenGlCanvas : public QOpenGLWidget {
  Q_OBJECT

 public:
  OpenGlCanvas(FrameSource source, QWidget* parent);
  ~OpenGlCanvas() override;

  /// The context worked once and does not any more.
  bool isLost() const;

 signals:
  /// The context cannot draw the scene.
  void failed();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void initializeGL() override;
  void paintGL() override;

 private:
  void releaseRenderer();

  FrameSource m_source;
  std::unique_ptr<OpenGlRenderer> m_renderer;
  QMetaObject::Connection m_contextConnection;
};

}  // namespace ui
