#include "app/scenes_command.h"

#include <QCoreApplication>
#include <QDir>

#include "ui/files/scene_file.h"

namespace app {

namespace {

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(app::ScenesCommand)
};

ExitStatus list() {
  QString lines;
  for (const QString& name : ui::builtInScenes()) {
    lines += name + '\t' + QString::fromStdString(ui::builtInScene(name).description) + '\n';
  }
  return printed(lines);
}

ExitStatus exportTo(const QString& folder) {
  if (!QDir().mkpath(folder)) {
    return failure(kFailed, Texts::tr("%1: the folder cannot be made").arg(folder));
  }
  for (const QString& name : ui::builtInScenes()) {
    const QString file = QDir(folder).filePath(name + QStringLiteral(".json"));
    const QString error = ui::writeSceneFile(file, ui::builtInScene(name));
    if (!error.isEmpty()) return failure(kFailed, file + QStringLiteral(": ") + error);
  }
  return kSuccess;
}

}  // namespace

ExitStatus runScenes(const ScenesCall& call) {
  return call.folder.isEmpty() ? list() : exportTo(call.folder);
}

}  // namespace app
