#include "ui/view/selection_drawing.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "ui/view/camera.h"
#include "ui/view/drawing.h"
#include "ui/view/picking.h"
#include "ui/view/scene_look.h"
#include "ui/view/shown_scene.h"
#include "ui/view/weight_drawing.h"

namespace ui {

namespace {

constexpr double kRingMargin = 8;  // from the weight to the ring's outer edge [px]
constexpr double kRingWidth = 3;   // [px]
constexpr double kHalo = 1.5;      // in the room's color, on both sides of the ring [px]
constexpr double kGripRadius = 7;  // [px]
constexpr double kWordsGap = 10;   // between ring and words [px]

void addRing(const Eigen::Vector2d& center, double radius, const Theme& theme, Layer& layer) {
  layer.discs.push_back({center, radius, kRingMargin + kHalo, kRingWidth + 2 * kHalo, 0,
                         withOpacity(theme.room, 0.8)});
  layer.discs.push_back({center, radius, kRingMargin, kRingWidth, 0, theme.text.rgb()});
}

/// The start velocity as an arrow with a grip; a plain stroke where there is none.
void addGrip(const core::Weight& weight, const ArrowScales& scales, const Camera& camera,
             const Theme& theme, Layer& layer) {
  const Eigen::Vector2d center = core::startPosition(weight);
  const Eigen::Vector2d velocity = core::startVelocity(weight);
  const Eigen::Vector2d grip = camera.toMetres(velocityGrip(weight, scales, camera));
  const QRgb color = theme.kinetic.rgb();
  const Eigen::Vector2d tip = center + scales.pixelsPerSpeed() / camera.scale() * velocity;
  layer.lines.push_back({center, grip, 1.5, withOpacity(theme.kinetic, 0.5)});
  if (velocity.norm() > 0) layer.arrows.push_back({center, tip, 3, color});
  layer.discs.push_back({grip, 0, kGripRadius, 2, withOpacity(theme.room, 0.5), color});
}

void addRejected(const core::Weight& weight, double radius, const Theme& theme, Layer& layer) {
  const Eigen::Vector2d place = core::startPosition(weight);
  if (weight.rope)
    layer.lines.push_back({weight.rope->pivot, place, 2, withOpacity(theme.drift, 0.7)});
  layer.discs.push_back({place, radius, 3, 2.5, withOpacity(theme.drift, 0.25), theme.drift.rgb()});
}

/// A disc that words stand beside.
struct WordsPlace {
  QPointF middle;  ///< [px]
  double reach;    ///< how far from there words begin [px]
  bool isLeft;     ///< of it, if there is room
};

/// Where a box of words can stand, the best place first.
std::vector<QRectF> placesFor(QSizeF box, const WordsPlace& place) {
  const QPointF middle = place.middle;
  const double left = middle.x() - place.reach - box.width(), right = middle.x() + place.reach;
  const double first = place.isLeft ? left : right, second = place.isLeft ? right : left;
  const double centered = middle.x() - box.width() / 2;
  // Below, because the rope is above.
  const double below = middle.y() + place.reach / 2, farBelow = middle.y() + place.reach;
  const double above = middle.y() - place.reach - box.height();
  std::vector<QRectF> boxes;
  for (const QPointF corner :
       {QPointF(first, below), QPointF(second, below), QPointF(centered, farBelow),
        QPointF(first, farBelow + box.height()), QPointF(second, farBelow + box.height()),
        QPointF(first, above), QPointF(second, above)})
    boxes.emplace_back(corner, box);
  return boxes;
}

/// How many weights of the first run such a box would cover.
std::size_t coveredBy(const QRectF& box, const ShownScene& shown, const Camera& camera) {
  const double least = leastRadius(shown);
  std::size_t covered = 0;
  for (std::size_t i = 0; i < shown.runs[0].weights.size(); ++i) {
    const double radius = std::max(shown.scene.weights[i].radius * camera.scale(), least);
    const QPointF middle = camera.toPixels(shown.runs[0].weights[i].position);
    const QRectF reached = box.adjusted(-radius, -radius, radius, radius);
    covered += reached.contains(middle) ? 1 : 0;
  }
  return covered;
}

/// The best place inside the picture. Where weights stand still it is one that covers the fewest of
/// them; beside weights that move it would jump about.
QPointF cornerOf(QSizeF box, const WordsPlace& place, const ShownScene& shown,
                 const Camera& camera) {
  const std::vector<QRectF> boxes = placesFor(box, place);
  const QRectF picture(QPointF(0, 0), camera.viewport());
  const bool standsStill = shown.marks.selection->isMovable;
  QPointF best = boxes.front().topLeft();
  std::size_t least = SIZE_MAX;
  for (const QRectF& candidate : boxes) {
    if (!picture.contains(candidate)) continue;
    const std::size_t covered = standsStill ? coveredBy(candidate, shown, camera) : 0;
    if (covered >= least) continue;
    least = covered;
    best = candidate.topLeft();
  }
  return best;
}

void addWords(const QStringList& words, const WordsPlace& place, const ShownScene& shown,
              const Camera& camera, const SceneLook& look, Drawing& drawing) {
  double width = 0;
  for (const QString& line : words) width = std::max(width, widthOf(line, look.font));
  const double height = static_cast<double>(words.size()) * lineHeight(look.font);
  QPointF corner = cornerOf({width, height}, place, shown, camera);
  for (const QString& line : words) {
    drawing.texts.push_back({camera.toMetres(corner), QPointF(0, 0), line, look.font,
                             look.theme.text.rgb(), withOpacity(look.theme.room, 0.85)});
    corner.ry() += lineHeight(look.font);
  }
}

}  // namespace

void drawSelection(const ShownScene& shown, const Camera& camera, const SceneLook& look,
                   Drawing& drawing) {
  const std::optional<ShownSelection>& selection = shown.marks.selection;
  if (!selection || shown.runs.empty()) return;
  const auto index = static_cast<std::size_t>(selection->weight);
  const double least = leastRadius(shown) / camera.scale();
  Layer& layer = drawing.layers[kFrontLayer];
  // A weight of a draft that cannot run may be in no run.
  const bool isInRuns = index < shown.runs[0].weights.size();
  if (!isInRuns && !selection->rejected) return;
  const core::Weight& weight =
      selection->rejected ? *selection->rejected : shown.scene.weights[index];
  const double radius = std::max(weight.radius, least);
  if (isInRuns) {
    const double ring = std::max(shown.scene.weights[index].radius, least);
    addRing(shown.runs[0].weights[index].position, ring, look.theme, layer);
  }
  if (selection->rejected) addRejected(weight, radius, look.theme, layer);
  if (selection->isMovable) addGrip(weight, shown.marks.arrows.scales, camera, look.theme, layer);
  const Eigen::Vector2d center =
      selection->rejected ? core::startPosition(weight) : shown.runs[0].weights[index].position;
  const QPointF grip = velocityGrip(weight, shown.marks.arrows.scales, camera);
  const bool gripIsRight = selection->isMovable && grip.x() > camera.toPixels(center).x();
  const double reach = radius * camera.scale() + kRingMargin + kWordsGap;
  addWords(selection->words, {camera.toPixels(center), reach, gripIsRight}, shown, camera, look,
           drawing);
}

}  // namespace ui
