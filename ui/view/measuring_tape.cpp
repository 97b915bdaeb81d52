#include "ui/view/measuring_tape.h"

#include <algorithm>

#include <QCoreApplication>

#include "ui/view/camera.h"
#include "ui/view/drawing.h"
#include "ui/view/length_text.h"
#include "ui/view/scene_look.h"
#include "ui/view/words_beside.h"

namespace ui {

namespace {

constexpr double kWidth = 3;     // [px]
constexpr double kTickEnd = 9;   // half of the strokes across its ends [px]
constexpr double kDistance = 8;  // from the tape to its words [px]

QFont largeFont(const SceneLook& look) {
  QFont font = look.font;
  font.setPixelSize(look.font.pixelSize() * 5 / 4);
  font.setBold(true);
  return font;
}

/// The right angle below the tape: how far it leads to the right, then how far up.
void addLegs(const MeasuringTape& tape, QRgb color, Layer& layer) {
  const Eigen::Vector2d corner(tape.to.x(), tape.from.y());
  layer.lines.push_back({tape.from, corner, 1.5, color});
  layer.lines.push_back({corner, tape.to, 1.5, color});
}

void addEnds(const MeasuringTape& tape, const Camera& camera, QRgb color, Layer& layer) {
  const Eigen::Vector2d way = tape.to - tape.from;
  if (way.norm() == 0) return;
  const Eigen::Vector2d across =
      Eigen::Vector2d(-way.y(), way.x()) / way.norm() * kTickEnd / camera.scale();
  for (const Eigen::Vector2d& end : {tape.from, tape.to})
    layer.lines.push_back({end - across, end + across, kWidth, color});
}

void addWords(const MeasuringTape& tape, const Camera& camera, const SceneLook& look,
              Drawing& drawing) {
  const Eigen::Vector2d way = tape.to - tape.from;
  const QString length = lengthText(way.norm(), camera);
  const QString parts = QCoreApplication::translate("ui::SceneView", "Δx %1, Δy %2")
                            .arg(lengthText(way.x(), camera), lengthText(way.y(), camera));
  const QFont large = largeFont(look);
  const QSizeF box(std::max(widthOf(length, large), widthOf(parts, look.font)),
                   lineHeight(large) + lineHeight(look.font));
  const QPointF corner =
      cornerBeside(camera.toPixels(tape.from), camera.toPixels(tape.to), box, kDistance);
  const QRgb plate = withOpacity(look.theme.room, 0.85);
  const auto add = [&](const QString& words, const QFont& font, double top) {
    const QPointF place = corner + QPointF((box.width() - widthOf(words, font)) / 2, top);
    drawing.texts.push_back(
        {camera.toMetres(place), QPointF(0, 0), words, font, look.theme.text.rgb(), plate});
  };
  add(parts, look.font, lineHeight(large));
  add(length, large, 0);
}

}  // namespace

void drawTape(const MeasuringTape& tape, const Camera& camera, const SceneLook& look,
              Drawing& drawing) {
  Layer& layer = drawing.layers[kToolLayer];
  addLegs(tape, withOpacity(look.theme.lostToImpacts, 0.6), layer);
  layer.lines.push_back({tape.from, tape.to, kWidth, look.theme.lostToImpacts.rgb()});
  addEnds(tape, camera, look.theme.lostToImpacts.rgb(), layer);
  addWords(tape, camera, look, drawing);
}

}  // namespace ui
