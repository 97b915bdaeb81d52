#include "ui/view/legend.h"

#include <algorithm>

#include <QCoreApplication>

#include "ui/view/camera.h"
#include "ui/view/room_drawing.h"
#include "ui/view/scene_look.h"
#include "ui/view/shown_scene.h"

namespace ui {

namespace {

constexpr double kEdge = 10;         // around the band [px]
constexpr double kMarkerRadius = 6;  // [px]
constexpr double kMarkerSpace = 20;  // from a marker's left edge to its words [px]
constexpr double kEntryGap = 24;     // between entries [px]
constexpr double kScaleSpace = 380;  // kept free for the scale bar [px]
constexpr double kTickHeight = 9;    // at the ends of the scale bar [px]
constexpr double kBarWidth = 2;      // [px]

/// Upper left corner of each entry within the band, in rows that leave room for the scale bar
/// where the picture is wide enough for both.
std::vector<QPointF> entryCorners(const std::vector<ShownRun>& runs, const SceneLook& look,
                                  double width) {
  const double right = std::max(width - kScaleSpace, width / 2);
  std::vector<QPointF> corners;
  QPointF next(kEdge, look.headerHeight + kEdge);
  for (const ShownRun& run : runs) {
    const double entryWidth = kMarkerSpace + widthOf(run.name, look.font);
    if (next.x() > kEdge && next.x() + entryWidth > right)
      next = QPointF(kEdge, next.y() + lineHeight(look.font));
    corners.push_back(next);
    next.rx() += entryWidth + kEntryGap;
  }
  return corners;
}

void addWords(const QString& words, QPointF corner, const QColor& color, const Camera& camera,
              const SceneLook& look, Drawing& drawing) {
  drawing.texts.push_back({camera.toMetres(corner), QPointF(0, 0), words, look.font, color.rgb(),
                           withOpacity(look.theme.background, 0.85)});
}

/// Filled for the first run, as its weights are where all runs are in one view.
Disc marker(std::size_t place, QPointF center, const Camera& camera, const Theme& theme) {
  const QRgb color = theme.runs[place % theme.runs.size()].rgb();
  const QRgb fill = place == 0 ? color : 0;
  return {camera.toMetres(center), 0, kMarkerRadius + 0.5, 2.5, fill, color};
}

/// The bar, with its length in words left of it, which say where its left end is [px].
struct ScaleBar {
  double left;
  double right;
  QString words;
  double wordsLeft;
};

ScaleBar scaleBar(const Ruler& ruler, const Camera& camera, const SceneLook& look) {
  ScaleBar bar;
  bar.right = camera.snapped(camera.viewport().width() - kEdge - kMarkerRadius);
  bar.left = camera.snapped(bar.right - ruler.spacing * camera.scale());
  // Far from the origin the ruler counts kilometres even in close-ups.
  const bool isReadable = ruler.spacing >= 0.01 * ruler.unit;
  const Ruler own = isReadable ? ruler : rulerFor(ruler.spacing, ruler.spacing);
  bar.words = own.textAt(ruler.spacing);
  bar.wordsLeft = bar.left - widthOf(bar.words, look.font) - kEdge;
  return bar;
}

void addScaleBar(const ScaleBar& bar, const Camera& camera, const SceneLook& look,
                 Drawing& drawing) {
  const double top = look.headerHeight + kEdge;
  const double middle = camera.snapped(top + (lineHeight(look.font) - kBarWidth) / 2);
  const double tickTop = middle + (kBarWidth - kTickHeight) / 2;
  const QRectF stroke(bar.left, middle, bar.right - bar.left, kBarWidth);
  const QRectF tick(bar.left, camera.snapped(tickTop), kBarWidth, kTickHeight);
  for (const QRectF& part : {stroke, tick, tick.translated(stroke.width() - kBarWidth, 0)})
    drawing.layers[kFrontLayer].rectangles.push_back(
        rectangleAt(part, camera, look.theme.faintText.rgb()));
  addWords(bar.words, {bar.wordsLeft, top}, look.theme.faintText, camera, look, drawing);
}

}  // namespace

double legendHeight(const std::vector<ShownRun>& runs, const SceneLook& look, double width) {
  const std::vector<QPointF> corners = entryCorners(runs, look, width);
  const double top = corners.empty() ? look.headerHeight + kEdge : corners.back().y();
  // Below it half a line is free for the number at the ceiling.
  return top - look.headerHeight + 1.6 * lineHeight(look.font);
}

void drawLegend(const std::vector<ShownRun>& runs, const Ruler& ruler, bool enlarged,
                const Camera& camera, const SceneLook& look, Drawing& drawing) {
  const double top = look.headerHeight + kEdge;
  const std::vector<QPointF> corners = entryCorners(runs, look, camera.viewport().width());
  double firstRowEnd = 0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const QPointF center = corners[r] + QPointF(kMarkerRadius, lineHeight(look.font) / 2);
    const QPointF words = corners[r] + QPointF(kMarkerSpace, 0);
    drawing.layers[kFrontLayer].discs.push_back(marker(runs[r].place, center, camera, look.theme));
    addWords(runs[r].name, words, look.theme.text, camera, look, drawing);
    if (words.y() == top) firstRowEnd = words.x() + widthOf(runs[r].name, look.font) + kEntryGap;
  }
  const ScaleBar bar = scaleBar(ruler, camera, look);
  if (bar.wordsLeft < firstRowEnd) return;
  addScaleBar(bar, camera, look, drawing);
  const QString note = QCoreApplication::translate("ui::SceneView", "weights enlarged");
  const QPointF corner(bar.wordsLeft - widthOf(note, look.font) - kEntryGap, top);
  if (enlarged && corner.x() >= firstRowEnd)
    addWords(note, corner, look.theme.faintText, camera, look, drawing);
}

}  // namespace ui
