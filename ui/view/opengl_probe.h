#pragma once

#include <QString>
#include <QSurfaceFormat>

namespace ui {

/// What OpenGL there is to draw with.
struct OpenGlSupport {
  bool usable = false;    ///< a context of version 3.3 or later, core profile, was made
  bool software = false;  ///< drawn by the processor
  QString version;        ///< such as "4.5"
  QString renderer;       ///< such as "llvmpipe"
};

/// Tries OpenGL without a window; takes some tens of milliseconds.
///
/// A QOpenGLWidget that is shown where no context can be had crashes inside Qt, so ask here
/// before one is created.
/// @pre a QGuiApplication exists
OpenGlSupport probeOpenGl();

/// The context that is asked for, when probing and by the view.
QSurfaceFormat sceneSurfaceFormat();

}  // namespace ui
