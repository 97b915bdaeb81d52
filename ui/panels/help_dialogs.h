#pragma once

class QWidget;

namespace ui {

class Commands;

/// Lists all keys and what the mouse does in the scene.
void showKeys(const Commands& commands, QWidget* window);

/// Says what the program is.
void showAbout(QWidget* window);

}  // namespace ui
