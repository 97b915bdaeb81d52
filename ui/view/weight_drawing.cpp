#include "ui/view/weight_drawing.h"

#include <algorithm>
#include <utility>

#include "ui/view/camera.h"
#include "ui/view/hanging_rope.h"
#include "ui/view/scene_look.h"
#include "ui/view/shown_scene.h"
#include "ui/view/trails.h"

namespace ui {

namespace {

constexpr double kRingWidth = 2.2;      // of the outlines [px]
constexpr double kThinRingWidth = 1.2;  // with many weights
constexpr std::size_t kMany = 100;      // with more weights than these, strokes are thinner

/// Strokes of one run: the first run's are stronger than those of the others.
struct RunStyle {
  QRgb rope;
  double ropeWidth;  ///< [px]; a rod's is twice that
  double trailWidth;
  double trailOpacity;
};

RunStyle styleOf(std::size_t run, const ShownScene& shown, const Theme& theme) {
  const bool many = shown.scene.weights.size() > kMany;
  // A thousand opaque ropes side by side would be a brown slab.
  const double share = many ? 0.3 : 1;
  if (run == 0)
    return {withOpacity(theme.rope, share), many ? 1.0 : 2.0, many ? 1.5 : 3.0, many ? 0.55 : 0.8};
  return {withOpacity(theme.runs[run % theme.runs.size()], 0.7 * share), many ? 1.0 : 1.25,
          many ? 1.0 : 1.75, many ? 0.35 : 0.55};
}

bool hangsOnRope(const core::WeightState& weight) {
  return weight.phase == core::Phase::kTethered || weight.phase == core::Phase::kSlack;
}

void addRope(const core::Rope& rope, const core::WeightState& weight, const RunStyle& style,
             Layer& layer) {
  if (weight.phase == core::Phase::kSlack) {
    std::vector<Eigen::Vector2d> points = hangingRope(rope.pivot, weight.position, rope.length);
    // What would hang through the floor lies on it.
    for (Eigen::Vector2d& point : points) point.y() = std::max(point.y(), 0.0);
    layer.polylines.push_back({std::move(points), style.ropeWidth, style.rope, /*fading=*/false});
    return;
  }
  const double width = rope.rigid ? 2 * style.ropeWidth : style.ropeWidth;
  layer.lines.push_back({rope.pivot, weight.position, width, style.rope});
}

Disc filledDisc(const ShownScene& shown, std::size_t index, double least, const Theme& theme) {
  const QRgb fill = shown.colors[index];
  return {shown.runs[0].weights[index].position,
          std::max(shown.scene.weights[index].radius, least),
          0,
          theme.dark ? 1.25 : 1.0,
          fill,
          mixed(fill, theme.outline.rgb(), theme.dark ? 0.6 : 0.5)};
}

/// Joins a weight to an outline that stands clear of its center; the outline stays empty.
void addJoint(const Eigen::Vector2d& weight, const Eigen::Vector2d& outline, double radius,
              const QColor& color, Layer& layer) {
  const Eigen::Vector2d way = outline - weight;
  const double length = way.norm();
  if (length > radius)
    layer.lines.push_back(
        {weight, outline - radius / length * way, 1.25, withOpacity(color, 0.75)});
}

}  // namespace

double leastRadius(const ShownScene& shown) {
  constexpr std::size_t kVeryMany = 500;
  return shown.scene.weights.size() > kVeryMany ? kLeastRadius / 2 : kLeastRadius;
}

bool enlargesWeights(const ShownScene& shown, const Camera& camera) {
  const double least = leastRadius(shown);
  return std::any_of(shown.scene.weights.begin(), shown.scene.weights.end(),
                     [&camera, least](const core::Weight& weight) {
                       return weight.radius * camera.scale() < least;
                     });
}

void drawTrails(const ShownScene& shown, const Trails& trails, const SceneLook& look,
                Drawing& drawing) {
  if (!look.trails || trails.pointsEach() == 0) return;
  // The first run's trails lie over those of the others.
  for (std::size_t r = shown.runs.size(); r-- > 0;) {
    const RunStyle style = styleOf(r, shown, look.theme);
    for (std::size_t i = 0; i < shown.runs[r].weights.size(); ++i) {
      std::vector<Eigen::Vector2d> points = trails.points(static_cast<int>(r), static_cast<int>(i));
      if (points.empty()) continue;
      const QColor color = r == 0 ? QColor(visibleInRoom(shown.colors[i], look.theme))
                                  : look.theme.runs[r % look.theme.runs.size()];
      drawing.layers[kTrailLayer].polylines.push_back({std::move(points), style.trailWidth,
                                                       withOpacity(color, style.trailOpacity),
                                                       /*fading=*/true});
    }
  }
}

void drawRopes(const ShownScene& shown, const SceneLook& look, Drawing& drawing) {
  Layer& layer = drawing.layers[kRopeLayer];
  const std::vector<core::Weight>& weights = shown.scene.weights;
  for (std::size_t r = shown.runs.size(); r-- > 0;) {
    const RunStyle style = styleOf(r, shown, look.theme);
    for (std::size_t i = 0; i < weights.size(); ++i)
      if (weights[i].rope && hangsOnRope(shown.runs[r].weights[i]))
        addRope(*weights[i].rope, shown.runs[r].weights[i], style, layer);
  }
  const bool many = weights.size() > kMany;
  const double pivotRadius = many ? 2 : 4;
  for (const core::Weight& weight : weights)
    if (weight.rope)
      layer.discs.push_back({weight.rope->pivot, 0, pivotRadius, 0, look.theme.wall.rgb(), 0});
}

void drawWeights(const ShownScene& shown, const Camera& camera, const SceneLook& look,
                 Drawing& drawing) {
  if (shown.runs.empty()) return;
  Layer& layer = drawing.layers[kWeightLayer];
  const std::vector<core::WeightState>& first = shown.runs[0].weights;
  const double least = leastRadius(shown) / camera.scale();
  const double ring = first.size() > kMany ? kThinRingWidth : kRingWidth;
  for (std::size_t i = 0; i < first.size(); ++i)
    layer.discs.push_back(filledDisc(shown, i, least, look.theme));
  for (std::size_t r = 1; r < shown.runs.size(); ++r) {
    const QColor& color = look.theme.runs[r % look.theme.runs.size()];
    for (std::size_t i = 0; i < first.size(); ++i) {
      const Eigen::Vector2d& place = shown.runs[r].weights[i].position;
      const double radius = std::max(shown.scene.weights[i].radius, least);
      layer.discs.push_back({place, radius, ring, ring, 0, color.rgb()});
      addJoint(first[i].position, place, radius + ring / camera.scale(), color, layer);
    }
  }
}

}  // namespace ui
