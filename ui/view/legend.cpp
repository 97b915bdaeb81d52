#include "ui/view/legend.h"

#include <algorithm>

#include <QCoreApplication>
#include <QStringList>

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

/// One name in the band, with its place; a name too long for the picture takes two lines.
struct Entry {
  QPointF corner;  // upper left [px]
  QStringList lines;
  double width = 0;  // [px]
};

/// The name in one line, or broken between method and step where the picture is too narrow.
QStringList linesOf(const QString& name, const SceneLook& look, double width) {
  const bool fits = kEdge + kMarkerSpace + widthOf(name, look.font) <= width - kEdge;
  const qsizetype comma = name.indexOf(QStringLiteral(", "));
  if (fits || comma < 0) return {name};
  return {name.left(comma + 1), name.mid(comma + 2)};
}

/// In rows, the first of which leaves room for the scale bar where the picture is wide enough
/// for both.
std::vector<Entry> entriesOf(const std::vector<ShownRun>& runs, const SceneLook& look,
                             double width) {
  const double top = look.headerHeight + kEdge;
  std::vector<Entry> entries;
  QPointF next(kEdge, top);
  qsizetype linesInRow = 1;
  for (const ShownRun& run : runs) {
    Entry entry{next, linesOf(run.name, look, width)};
    for (const QString& line : entry.lines)
      entry.width = std::max(entry.width, kMarkerSpace + widthOf(line, look.font));
    const double right = next.y() > top ? width - kEdge : std::max(width - kScaleSpace, width / 2);
    if (next.x() > kEdge && next.x() + entry.width > right) {
      next = QPointF(kEdge, next.y() + static_cast<double>(linesInRow) * lineHeight(look.font));
      linesInRow = 1;
    }
    entry.corner = next;
    linesInRow = std::max(linesInRow, entry.lines.size());
    next.rx() += entry.width + kEntryGap;
    entries.push_back(std::move(entry));
  }
  return entries;
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
  double height = kEdge + lineHeight(look.font);
  for (const Entry& entry : entriesOf(runs, look, width))
    height = std::max(height, entry.corner.y() - look.headerHeight +
                                  static_cast<double>(entry.lines.size()) * lineHeight(look.font));
  // Below it half a line is free for the number at the ceiling.
  return height + 0.6 * lineHeight(look.font);
}

void drawLegend(const std::vector<ShownRun>& runs, const Ruler& ruler, bool enlarged,
                const Camera& camera, const SceneLook& look, Drawing& drawing) {
  const double top = look.headerHeight + kEdge;
  const std::vector<Entry> entries = entriesOf(runs, look, camera.viewport().width());
  double firstRowEnd = 0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Entry& entry = entries[r];
    const QPointF center = entry.corner + QPointF(kMarkerRadius, lineHeight(look.font) / 2);
    drawing.layers[kFrontLayer].discs.push_back(marker(runs[r].place, center, camera, look.theme));
    QPointF words = entry.corner + QPointF(kMarkerSpace, 0);
    for (const QString& line : entry.lines) {
      addWords(line, words, look.theme.text, camera, look, drawing);
      words.ry() += lineHeight(look.font);
    }
    if (entry.corner.y() == top) firstRowEnd = entry.corner.x() + entry.width + kEntryGap;
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
