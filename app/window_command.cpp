#include "app/window_command.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QStatusBar>
#include <QTimer>

#include "core/system/screen.h"
#include "ui/control/commands.h"
#include "ui/control/draft_keeper.h"
#include "ui/control/first_scene.h"
#include "ui/control/settings.h"
#include "ui/control/translations.h"
#include "ui/help/tour.h"
#include "ui/main_window.h"

namespace app {

bool hasDisplay() {
  const QString platform = qEnvironmentVariable("QT_QPA_PLATFORM");
  if (platform == QStringLiteral("offscreen") || platform == QStringLiteral("minimal")) {
    return false;
  }
  return !platform.isEmpty() || core::hasScreen();
}

void startNoBus() {
  const QString bus = qEnvironmentVariable("XDG_RUNTIME_DIR") + QStringLiteral("/bus");
  if (!qEnvironmentVariableIsEmpty("DBUS_SESSION_BUS_ADDRESS") || QFile::exists(bus)) return;
  qputenv("DBUS_SESSION_BUS_ADDRESS", "disabled:");
}

QString windowFailure(const QString& reason) {
  QStringList displays;
  for (const char* name : {"QT_QPA_PLATFORM", "WAYLAND_DISPLAY", "DISPLAY"}) {
    if (qEnvironmentVariableIsEmpty(name)) continue;
    displays << QLatin1String(name) + '=' + qEnvironmentVariable(name);
  }
  // Qt advises to install the program again, which helps nobody whose display is gone.
  const bool isDisplay = reason.startsWith(QStringLiteral("This application failed to start"));
  return QCoreApplication::translate("app::main", "the window cannot be opened: %1")
      .arg(isDisplay ? QCoreApplication::translate("app::main", "no display answers (%1)")
                           .arg(displays.join(QStringLiteral(", ")))
                     : reason);
}

ExitStatus runWindow(const WindowCall& call) {
  ui::speak(ui::Settings().language());
  const ui::FirstScene first = ui::firstScene(call.scene);
  if (!first.scene) return failure(kRefused, call.scene + QStringLiteral(": ") + first.message);
  ui::MainWindow window(*first.scene, first.file);
  window.keepDraftsIn(ui::draftFolder());
  window.show();
  // Whoever names a scene knows what to do with it.
  if (call.scene.isEmpty() && ui::isTourDue())
    QTimer::singleShot(0, window.commands().action(ui::Command::kTour), &QAction::trigger);
  window.statusBar()->showMessage(first.message);
  return QApplication::exec() == 0 ? kSuccess : kFailed;
}

}  // namespace app
