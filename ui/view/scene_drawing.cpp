#include "ui/view/scene_drawing.h"

#include "ui/view/arrow_drawing.h"
#include "ui/view/camera.h"
#include "ui/view/legend.h"
#include "ui/view/room_drawing.h"
#include "ui/view/scene_look.h"
#include "ui/view/selection_drawing.h"
#include "ui/view/shown_scene.h"
#include "ui/view/target_drawing.h"
#include "ui/view/weight_drawing.h"

namespace ui {

namespace {

/// Height of what names runs and arrows above the room [px].
double bandHeight(const ShownScene& shown, const SceneLook& look, double width) {
  return legendHeight(shown.runs, look, width) + arrowLegendHeight(shown, look, width);
}

}  // namespace

double wordsTop(const ShownScene& shown, const Camera& camera, const SceneLook& look) {
  const double band = bandHeight(shown, look, camera.viewport().width());
  return look.headerHeight + band - lineHeight(look.font) / 2;
}

Drawing sceneDrawing(const ShownScene& shown, const Trails& trails, const Camera& camera,
                     const SceneLook& look) {
  Drawing drawing;
  drawing.background = look.theme.background.rgb();
  const core::Room& room = shown.scene.room;
  const Ruler ruler = roomRuler(room, camera, look);
  drawRoom(room, ruler, camera, look, drawing);
  if (shown.target) drawTarget(*shown.target, shown.runs, room, camera, look, drawing);
  const double top = wordsTop(shown, camera, look);
  drawNumbers(room, ruler, top, camera, look, drawing);
  drawTrails(shown, trails, look, drawing);
  drawRopes(shown, look, drawing);
  drawWeights(shown, camera, look, drawing);
  drawArrows(shown, camera, look, drawing);
  if (shown.step) drawStep(*shown.step, top, camera, look, drawing);
  drawSelection(shown, camera, look, drawing);
  drawLegend(shown.runs, ruler, enlargesWeights(shown, camera), camera, look, drawing);
  const double height = arrowLegendHeight(shown, look, camera.viewport().width());
  drawArrowLegend(shown, top - height, camera, look, drawing);
  drawTools(shown.marks.tools, shown.time, top, camera, look, drawing);
  return drawing;
}

QMarginsF sceneMargins(const ShownScene& shown, const SceneLook& look, double width) {
  const double height = lineHeight(look.font);
  const double numbersWidth = widthOf(QStringLiteral("00.00 m"), look.font);
  const double top = look.headerHeight + bandHeight(shown, look, width);
  return {numbersWidth + 20, top, numbersWidth / 2 + 10, height + 20};
}

}  // namespace ui
