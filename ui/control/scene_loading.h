#pragma once

#include <QString>

#include "ui/files/scene_file.h"

class QWidget;

namespace ui {

/// Reads a scene file for a window. A large one is read in another thread, while a dialog over
/// the window shows how far it is and everything goes on being drawn; a pipe or a device, for
/// which the window would have to wait, is refused.
///
/// @return  as readSceneFile(); neither scene nor error if the user gave it up
SceneOrError readForWindow(const QString& file, QWidget* window);

}  // namespace ui
