#pragma once

#include <vector>

#include <QRectF>

#include "core/scene/scene.h"
#include "ui/view/drawing.h"
#include "ui/view/shown_target.h"

namespace ui {

class Camera;
struct SceneLook;
struct ShownRun;

/// The stripe on the floor that shows a target [px].
QRectF targetStripe(const core::Target& target, const core::Room& room, const Camera& camera);

/// Adds the target as a stripe of rings on the floor, an arrow above its center, for each run
/// that has landed a mark where, and in words whether that is a hit, and when.
/// @param runs  as many as the target has landings
void drawTarget(const ShownTarget& target, const std::vector<ShownRun>& runs,
                const core::Room& room, const Camera& camera, const SceneLook& look,
                Drawing& drawing);

}  // namespace ui
