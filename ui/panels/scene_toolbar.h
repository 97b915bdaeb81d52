#pragma once

class QToolBar;

namespace ui {

class Commands;

/// A narrow column of buttons beside the scene: what is drawn in it, and the tools to measure it.
QToolBar* sceneToolbar(const Commands& commands);

}  // namespace ui
