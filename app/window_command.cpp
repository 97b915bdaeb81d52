#include "app/window_command.h"

#include <QApplication>
#include <QFileInfo>

#include "core/system/screen.h"
#include "ui/control/translations.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"

namespace app {

bool hasDisplay() {
  const QString platform = qEnvironmentVariable("QT_QPA_PLATFORM");
  if (platform == QStringLiteral("offscreen") || platform == QStringLiteral("minimal")) {
    return false;
  }
  return !platform.isEmpty() || core::hasScreen();
}

ExitStatus runWindow(const WindowCall& call) {
  ui::installTranslations(*QCoreApplication::instance());
  const ui::SceneOrError read = ui::readFileOrBuiltIn(call.scene);
  if (!read.scene) return failure(kRefused, call.scene + QStringLiteral(": ") + read.error);
  const QString file = QFileInfo::exists(call.scene) ? call.scene : QString();
  ui::MainWindow window(*read.scene, file);
  window.show();
  return QApplication::exec() == 0 ? kSuccess : kFailed;
}

}  // namespace app
