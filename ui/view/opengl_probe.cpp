#include "ui/view/opengl_probe.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLVersionFunctionsFactory>

namespace ui {

namespace {

/// Platforms whose OpenGL shows in a window. Others have none, or end the program when asked.
bool platformHasOpenGl() {
  const QString platform = QGuiApplication::platformName();
  return platform == QLatin1String("xcb") || platform.startsWith(QLatin1String("wayland")) ||
         platform == QLatin1String("windows") || platform == QLatin1String("cocoa");
}

bool isSoftware(const QString& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "software"})
    if (renderer.contains(QLatin1String(name), Qt::CaseInsensitive)) return true;
  return false;
}

}  // namespace

QSurfaceFormat sceneSurfaceFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  // Else a context that the driver has reset never says so.
  format.setOption(QSurfaceFormat::ResetNotification);
  return format;
}

OpenGlSupport probeOpenGl() {
  OpenGlSupport support;
  if (!platformHasOpenGl()) return support;
  QOpenGLContext context;
  context.setFormat(sceneSurfaceFormat());
  if (!context.create()) return support;
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!surface.isValid() || !context.makeCurrent(&surface)) return support;

  const QPair<int, int> version = context.format().version();
  auto* functions = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(&context);
  if (version >= qMakePair(3, 3) && functions && functions->initializeOpenGLFunctions()) {
    const auto* name = reinterpret_cast<const char*>(functions->glGetString(GL_RENDERER));
    const QString renderer = QString::fromLatin1(name);
    support.usable = true;
    support.software = isSoftware(renderer);
    support.version = QStringLiteral("%1.%2").arg(version.first).arg(version.second);
    // "llvmpipe (LLVM 15.0.6, 256 bits)": the words in front say enough.
    support.renderer = renderer.section(QLatin1Char('('), 0, 0).section(QLatin1Char('/'), 0, 0);
    support.renderer = support.renderer.trimmed();
  }
  context.doneCurrent();
  return support;
}

}  // namespace ui
