#include "ui/view/target_drawing.h"

#include <algorithm>

#include <QCoreApplication>
#include <QLocale>

#include "ui/chart/figure_text.h"
#include "ui/view/camera.h"
#include "ui/view/room_drawing.h"
#include "ui/view/scene_look.h"
#include "ui/view/shown_scene.h"

namespace ui {

namespace {

constexpr double kRise = 5;          // of the stripe above the floor [px]
constexpr double kLeastWidth = 4;    // [px]
constexpr double kArrowTop = 52;     // above the floor [px]
constexpr double kArrowTip = 8;      // above the floor [px]
constexpr double kArrowWidth = 4;    // of the shaft [px]
constexpr double kMarkRadius = 7;    // of a landing [px]
constexpr double kMarkerRadius = 6;  // of a run's sign before its words [px]
constexpr double kMarkerSpace = 20;  // from its left edge to the words [px]
constexpr double kEdge = 10;         // of the picture [px]

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::SceneView)
};

/// The middle part of the stripe that is `share` of its width.
QRectF middleOf(const QRectF& stripe, double share) {
  const double margin = (1 - share) / 2 * stripe.width();
  return stripe.adjusted(margin, 0, -margin, 0);
}

QString landingWords(const core::Target& target, const ShownLanding& landing) {
  const QString time = QLocale().toString(landing.time, 'f', 3);
  if (target.holds(landing.place)) return Words::tr("Hit at %1 s").arg(time);
  return Words::tr("Missed by %1 m at %2 s").arg(figure(target.missedBy(landing.place)), time);
}

/// One line over the target.
struct Line {
  QString words;
  const ShownRun* run;  // whose sign stands before it; null: none
};

std::vector<Line> linesOf(const ShownTarget& target, const std::vector<ShownRun>& runs) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < runs.size() && i < target.landings.size(); ++i) {
    if (!target.landings[i]) continue;
    lines.push_back(
        {landingWords(target.place, *target.landings[i]), runs.size() > 1 ? &runs[i] : nullptr});
  }
  if (lines.empty()) lines.push_back({Words::tr("Target"), nullptr});
  return lines;
}

Disc runDisc(const ShownRun& run, const Eigen::Vector2d& center, double radius,
             const SceneLook& look) {
  const QRgb color = look.theme.runs[run.place % look.theme.runs.size()].rgb();
  return {center, 0, radius + 0.5, 2.5, run.place == 0 ? color : 0, color};
}

void addLines(const std::vector<Line>& lines, QPointF below, const Camera& camera,
              const SceneLook& look, Drawing& drawing) {
  double width = 0;
  for (const Line& line : lines)
    width = std::max(width, widthOf(line.words, look.font) + (line.run ? kMarkerSpace : 0));
  const double right = std::max(kEdge, camera.viewport().width() - width - kEdge);
  QPointF corner(std::clamp(below.x() - width / 2, kEdge, right),
                 below.y() - static_cast<double>(lines.size()) * lineHeight(look.font));
  for (const Line& line : lines) {
    if (line.run) {
      const QPointF sign = corner + QPointF(kMarkerRadius, lineHeight(look.font) / 2);
      drawing.layers[kFrontLayer].discs.push_back(
          runDisc(*line.run, camera.toMetres(sign), kMarkerRadius, look));
    }
    const QPointF words = corner + QPointF(line.run ? kMarkerSpace : 0, 0);
    drawing.texts.push_back({camera.toMetres(words), QPointF(0, 0), line.words, look.font,
                             look.theme.text.rgb(), withOpacity(look.theme.room, 0.85)});
    corner.ry() += lineHeight(look.font);
  }
}

}  // namespace

QRectF targetStripe(const core::Target& target, const core::Room& room, const Camera& camera) {
  const RoomFrame frame = roomFrame(room, camera);
  const double west = camera.snapped(camera.toPixels({target.west(), 0}).x());
  const double east = camera.snapped(camera.toPixels({target.east(), 0}).x());
  const double missing = std::max(0.0, kLeastWidth - (east - west)) / 2;
  return {QPointF(west - missing, frame.floor.top() - kRise),
          QPointF(east + missing, frame.floor.bottom())};
}

void drawTarget(const ShownTarget& target, const std::vector<ShownRun>& runs,
                const core::Room& room, const Camera& camera, const SceneLook& look,
                Drawing& drawing) {
  const QRectF stripe = targetStripe(target.place, room, camera);
  const QRectF near = QRectF(QPointF(0, 0), camera.viewport()).adjusted(-16, -16, 16, 16);
  const QRgb ring = look.theme.drift.rgb();
  const auto addRing = [&](double share, QRgb color) {
    const QRectF seen = middleOf(stripe, share).intersected(near);
    if (!seen.isEmpty())
      drawing.layers[kRoomLayer].rectangles.push_back(rectangleAt(seen, camera, color));
  };
  addRing(1, ring);
  addRing(0.6, look.theme.room.rgb());
  addRing(0.2, ring);
  const QPointF center = camera.toPixels({target.place.center, 0});
  const auto above = [&](double height) { return camera.toMetres(center - QPointF(0, height)); };
  drawing.layers[kRopeLayer].arrows.push_back(
      {above(kArrowTop), above(kArrowTip), kArrowWidth, ring});
  for (std::size_t i = 0; i < runs.size() && i < target.landings.size(); ++i) {
    if (!target.landings[i]) continue;
    drawing.layers[kFrontLayer].discs.push_back(
        runDisc(runs[i], {target.landings[i]->place, 0}, kMarkRadius, look));
  }
  if (near.contains(center))
    addLines(linesOf(target, runs), center - QPointF(0, kArrowTop + 2), camera, look, drawing);
}

}  // namespace ui
