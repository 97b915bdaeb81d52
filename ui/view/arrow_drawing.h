#pragma once

namespace ui {

class Camera;
struct Drawing;
struct SceneLook;
struct ShownScene;

/// Height of the rows that name the arrows and state their scale; 0 where none are drawn [px].
/// @param width  of the picture [px]
double arrowLegendHeight(const ShownScene& shown, const SceneLook& look, double width);

/// Adds those rows: an arrow of each kind with its name, what an arrow as long as the one that
/// leads them stands for, and the selected weight's values.
/// @param top  of the rows [px]
void drawArrowLegend(const ShownScene& shown, double top, const Camera& camera,
                     const SceneLook& look, Drawing& drawing);

/// Adds the velocity of each weight of the first run, the forces on it, and the tension of its
/// rope in newtons, as far as they are shown. Numbers that would lie on each other are left out;
/// in crowds numbers, and in larger ones arrows too, stand at the selected weight alone.
void drawArrows(const ShownScene& shown, const Camera& camera, const SceneLook& look,
                Drawing& drawing);

}  // namespace ui
