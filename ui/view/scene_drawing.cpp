#include "ui/view/scene_drawing.h"

#include "ui/view/camera.h"
#include "ui/view/legend.h"
#include "ui/view/room_drawing.h"
#include "ui/view/scene_look.h"
#include "ui/view/shown_scene.h"
#include "ui/view/target_drawing.h"
#include "ui/view/weight_drawing.h"

namespace ui {

namespace {

/// Where the words of the legend end [px].
double numbersTop(const ShownScene& shown, const Camera& camera, const SceneLook& look) {
  const double legend = legendHeight(shown.runs, look, camera.viewport().width());
  return look.headerHeight + legend - lineHeight(look.font) / 2;
}

}  // namespace

Drawing sceneDrawing(const ShownScene& shown, const Trails& trails, const Camera& camera,
                     const SceneLook& look) {
  Drawing drawing;
  drawing.background = look.theme.background.rgb();
  const core::Room& room = shown.scene.room;
  const Ruler ruler = roomRuler(room, camera, look);
  drawRoom(room, ruler, camera, look, drawing);
  if (shown.target) drawTarget(*shown.target, shown.runs, room, camera, look, drawing);
  const double top = numbersTop(shown, camera, look);
  drawNumbers(room, ruler, top, camera, look, drawing);
  drawTrails(shown, trails, look, drawing);
  drawRopes(shown, look, drawing);
  drawWeights(shown, camera, look, drawing);
  if (shown.step) drawStep(*shown.step, top, camera, look, drawing);
  drawLegend(shown.runs, ruler, enlargesWeights(shown, camera), camera, look, drawing);
  return drawing;
}

QMarginsF sceneMargins(const ShownScene& shown, const SceneLook& look, double width) {
  const double height = lineHeight(look.font);
  const double numbersWidth = widthOf(QStringLiteral("00.00 m"), look.font);
  const double top = look.headerHeight + legendHeight(shown.runs, look, width);
  return {numbersWidth + 20, top, numbersWidth / 2 + 10, height + 20};
}

}  // namespace ui
