#include "ui/view/shown_step.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QLocale>

#include "ui/style/stage_color.h"
#include "ui/view/camera.h"
#include "ui/view/drawing.h"
#include "ui/view/scene_look.h"

namespace ui {

namespace {

constexpr double kArrowLength = 36;  // of the longest arrow at least [px]
constexpr double kWidth = 2.5;       // of an arrow's shaft [px]
constexpr double kEdge = 10;         // of the note, as of the legend above it [px]
constexpr double kMostEnlarged = 1e6;

}  // namespace

double enlargementOf(const ShownStep& step, const Camera& camera) {
  double longest = 0;
  for (const ShownSlope& slope : step.slopes)
    longest = std::max(longest, slope.way.norm() * camera.scale());
  double enlargement = 1;
  for (int i = 0; longest * enlargement < kArrowLength && enlargement < kMostEnlarged; ++i)
    enlargement *= i % 3 == 1 ? 2.5 : 2;
  return enlargement;
}

void drawStep(const ShownStep& step, double top, const Camera& camera, const SceneLook& look,
              Drawing& drawing) {
  const double enlargement = enlargementOf(step, camera);
  const auto placed = [&](const Eigen::Vector2d& place) -> Eigen::Vector2d {
    return step.anchor + enlargement * (place - step.anchor);
  };
  Layer& layer = drawing.layers[kFrontLayer];
  for (std::size_t i = 0; i < step.slopes.size(); ++i) {
    const ShownSlope& slope = step.slopes[i];
    const QColor color = stageColor(i, look.theme);
    const Eigen::Vector2d from = placed(slope.place);
    const Eigen::Vector2d to = from + enlargement * slope.way;
    layer.arrows.push_back({from, to, kWidth, color.rgb()});
    drawing.texts.push_back({to, QPointF(6, -lineHeight(look.font)), slope.name, look.font,
                             color.rgb(), withOpacity(look.theme.room, 0.7)});
  }
  for (const Eigen::Vector2d& place : {step.start, step.end})
    layer.discs.push_back({placed(place), 0, 5, 2, 0, look.theme.text.rgb()});
  if (enlargement == 1) return;
  const QString note = QCoreApplication::translate("ui::SceneView", "step × %1")
                           .arg(QLocale().toString(enlargement, 'g', 7));
  const QPointF corner(kEdge, top);
  drawing.texts.push_back({camera.toMetres(corner), QPointF(0, 0), note, look.font,
                           look.theme.faintText.rgb(), withOpacity(look.theme.background, 0.85)});
}

}  // namespace ui
