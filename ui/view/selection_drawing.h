#pragma once

namespace ui {

class Camera;
struct Drawing;
struct SceneLook;
struct ShownScene;

/// Adds the ring around the selected weight, the grip of its velocity, its words, and where a
/// draft that cannot run would have it start.
void drawSelection(const ShownScene& shown, const Camera& camera, const SceneLook& look,
                   Drawing& drawing);

}  // namespace ui
