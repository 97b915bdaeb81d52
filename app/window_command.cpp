#include "app/window_command.h"

#include <QAction>
#include <QApplication>
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
