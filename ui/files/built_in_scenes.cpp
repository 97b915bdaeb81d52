#include <QCoreApplication>
#include <QFileInfo>

#include "ui/files/lessons.h"
#include "ui/files/scene_file.h"

namespace ui {

namespace {

QString resourceOf(const QString& name) {
  return QStringLiteral(":/scenes/%1.json").arg(name);
}

}  // namespace

QStringList builtInScenes() {
  QStringList names;
  for (const Lesson& lesson : lessons()) names.append(lesson.name);
  return names;
}

core::Scene builtInScene(const QString& name) {
  const SceneOrError result = readSceneFile(resourceOf(name));
  Q_ASSERT(result.scene);
  return *result.scene;
}

SceneOrError readFileOrBuiltIn(const QString& fileOrName) {
  // A file of that name comes first: it is the user's own.
  if (QFileInfo::exists(fileOrName)) return readSceneFile(fileOrName);
  if (builtInScenes().contains(fileOrName)) return {builtInScene(fileOrName), {}};
  return {std::nullopt, QCoreApplication::translate("ui::BuiltInScenes",
                                                    "no file or built-in scene of that name")};
}

}  // namespace ui
