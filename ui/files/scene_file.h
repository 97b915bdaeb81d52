#pragma once

#include <optional>

#include <QByteArray>
#include <QString>
#include <QStringList>

#include "core/scene/scene.h"
#include "core/trade/work_meter.h"

namespace ui {

/// A scene, or one line that names the place in the file and what is wrong there.
struct SceneOrError {
  std::optional<core::Scene> scene;
  QString error;
};

/// Reads the text of a scene file (format: "angry-cuts/scene", version 1). Refuses the
/// whole text for any fault; a refused text has no scene.
SceneOrError parseScene(const QByteArray& text);

/// Reads what sceneText() made of a scene, even one that cannot run.
SceneOrError parseDraft(const QByteArray& text);

/// Reads a scene file of at most 64 MiB. Waits for what comes through a pipe.
/// @param progress  may be empty; where it stops the reading there is neither scene nor error
SceneOrError readSceneFile(const QString& file, const core::Progress& progress = {});

/// Why a window should not read this file: it would wait for what comes through a pipe or a
/// device. Empty if nothing is known against it.
QString obstacleToReading(const QString& file);

/// The scene as a file's text: UTF-8 JSON, indented, every value written so that it reads
/// back to the same double.
/// @param scene  need not be able to run, but its numbers are finite
QByteArray sceneText(const core::Scene& scene);

/// Writes a scene file, whole or not at all.
/// @return empty, or what went wrong in words
QString writeSceneFile(const QString& file, const core::Scene& scene);

/// Names of the built-in scenes, in menu order, such as "seven-weights".
QStringList builtInScenes();
/// @pre `name` is one of builtInScenes()
core::Scene builtInScene(const QString& name);

/// A file, or the name of a built-in scene.
SceneOrError readFileOrBuiltIn(const QString& fileOrName);

}  // namespace ui
