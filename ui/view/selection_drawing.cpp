#include "ui/view/selection_drawing.h"

#include <algorithm>

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

/// Where words stand beside a disc.
struct WordsPlace {
  Eigen::Vector2d center;  ///< of the disc [m]
  double radius;           ///< [m]
  bool isLeft;             ///< of it, if there is room
};

void addWords(const QStringList& words, const WordsPlace& place, const Camera& camera,
              const SceneLook& look, Drawing& drawing) {
  double width = 0;
  for (const QString& line : words) width = std::max(width, widthOf(line, look.font));
  const double reach = place.radius * camera.scale() + kRingMargin + kWordsGap;
  const double height = static_cast<double>(words.size()) * lineHeight(look.font);
  const QPointF middle = camera.toPixels(place.center);
  const bool fitsLeft = middle.x() - reach - width >= kWordsGap;
  const bool fitsRight = middle.x() + reach + width + kWordsGap <= camera.viewport().width();
  const bool isLeft = fitsLeft && (place.isLeft || !fitsRight);
  const double left = isLeft ? middle.x() - reach - width : middle.x() + reach;
  // Below, because the rope is above.
  double top = middle.y() + reach / 2;
  if (top + height > camera.viewport().height()) top = middle.y() - reach - height;
  for (const QString& line : words) {
    drawing.texts.push_back({camera.toMetres({left, top}), QPointF(0, 0), line, look.font,
                             look.theme.text.rgb(), withOpacity(look.theme.room, 0.85)});
    top += lineHeight(look.font);
  }
}

}  // namespace

void drawSelection(const ShownScene& shown, const Camera& camera, const SceneLook& look,
                   Drawing& drawing) {
  const std::optional<ShownSelection>& selection = shown.marks.selection;
  if (!selection || shown.runs.empty()) return;
  const auto index = static_cast<std::size_t>(selection->weight);
  const double least = kLeastRadius / camera.scale();
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
  addWords(selection->words, {center, radius, gripIsRight}, camera, look, drawing);
}

}  // namespace ui
