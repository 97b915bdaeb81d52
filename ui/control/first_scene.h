#pragma once

#include <optional>

#include <QString>

#include "core/scene/scene.h"

namespace ui {

/// The built-in scene that shows what the program is for.
extern const QString kDemonstration;

/// What a window opens with.
struct FirstScene {
  std::optional<core::Scene> scene;
  QString file;     ///< where the scene came from; empty: built in
  QString message;  ///< why there is no scene, or not the one of last time, or what else of last
                    ///< time was not found; may be empty
};

/// @param wanted  a file or the name of a built-in scene; empty: the scene of last time, or the
///                demonstration where that is gone
FirstScene firstScene(const QString& wanted);

/// Notes what a window shows now, for the next start.
/// @param file  empty: a built-in scene, which is known by its name, or none that could be found
///              again
void rememberScene(const QString& file, const core::Scene& scene);

}  // namespace ui
