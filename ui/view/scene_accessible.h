#pragma once

namespace ui {

/// Lets screen readers know what a SceneView shows: its name, and as its value what happened
/// there last. Call before the first of them asks.
void installSceneAccessible();

}  // namespace ui
