#pragma once

#include <vector>

#include <QPointF>

#include "ui/view/drawing.h"
#include "ui/view/ruler.h"

namespace ui {

class Camera;
struct SceneLook;
struct ShownRun;

/// Height of the band over the room that names the runs [px].
/// @param width  of the picture [px]
double legendHeight(const std::vector<ShownRun>& runs, const SceneLook& look, double width);

/// Adds the band: which weights, filled or outlined, belong to which run; at its right end,
/// where there is room for it, a bar as long as the ruler's spacing.
/// @param enlarged  some weights are drawn larger than they are, which a note says
void drawLegend(const std::vector<ShownRun>& runs, const Ruler& ruler, bool enlarged,
                const Camera& camera, const SceneLook& look, Drawing& drawing);

}  // namespace ui
