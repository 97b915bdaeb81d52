#include "ui/control/first_scene.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QHash>

#include "ui/control/settings.h"
#include "ui/files/scene_file.h"

namespace ui {

const QString kDemonstration = QStringLiteral("seven-weights");

namespace {

/// Names by what the scenes are called on screen.
QHash<QString, QString> builtInByTitle() {
  QHash<QString, QString> names;
  for (const QString& name : builtInScenes())
    names[QString::fromStdString(builtInScene(name).name)] = name;
  return names;
}

/// Nobody has asked for it now, so nobody expects to wait.
SceneOrError readLast(const QString& fileOrName) {
  const QString obstacle = obstacleToReading(fileOrName);
  return obstacle.isEmpty() ? readFileOrBuiltIn(fileOrName) : SceneOrError{{}, obstacle};
}

}  // namespace

FirstScene firstScene(const QString& wanted) {
  const Settings settings;
  const QString last = settings.lastScene();
  const QString name = !wanted.isEmpty() ? wanted : last.isEmpty() ? kDemonstration : last;
  SceneOrError read = wanted.isEmpty() ? readLast(name) : readFileOrBuiltIn(name);
  if (read.scene) {
    return {read.scene, QFileInfo::exists(name) ? name : QString(), settings.trouble()};
  }
  if (!wanted.isEmpty()) return {{}, {}, read.error};
  const QString message = QCoreApplication::translate(
      "ui::FirstScene", "The scene of last time, %1, was not opened: %2");
  return {builtInScene(kDemonstration), {}, message.arg(QFileInfo(last).fileName(), read.error)};
}

void rememberScene(const QString& file, const core::Scene& scene) {
  static const QHash<QString, QString> kBuiltIn = builtInByTitle();
  const QString title = QString::fromStdString(scene.name);
  Settings().setLastScene(file.isEmpty() ? kBuiltIn.value(title)
                                         : QFileInfo(file).absoluteFilePath());
}

}  // namespace ui
