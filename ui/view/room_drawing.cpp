#include "ui/view/room_drawing.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "ui/view/camera.h"
#include "ui/view/scene_look.h"

namespace ui {

namespace {

constexpr double kWallWidth = 4;         // [px]
constexpr double kFloorWidth = 9;        // [px]
constexpr double kLeastSpacing = 90;     // between numbers [px]
constexpr double kGap = 7;               // between numbers and walls or the edge [px]
constexpr double kLeastGridSpacing = 9;  // between the finer lines of the grid [px]

QRectF viewportOf(const Camera& camera) {
  return {QPointF(0, 0), camera.viewport()};
}

/// First and last multiple of `spacing` within an interval.
std::pair<double, double> multiplesWithin(double lowest, double highest, double spacing) {
  const double room = spacing * 1e-9;
  return {std::ceil((lowest - room) / spacing), std::floor((highest + room) / spacing)};
}

/// The seen part of the room [m], y up.
QRectF seenPart(const core::Room& room, const Camera& camera) {
  return camera.visibleMetres().intersected(QRectF(0, 0, room.width, room.height));
}

void addGrid(const core::Room& room, double spacing, const Camera& camera, QRgb color,
             Layer& layer) {
  const QRectF inside = roomFrame(room, camera).inside.intersected(viewportOf(camera));
  if (inside.isEmpty()) return;
  const QRectF seen = seenPart(room, camera);
  const double width = std::max(camera.snapped(1), 1 / camera.devicePixelRatio());
  const auto [west, east] = multiplesWithin(seen.left(), seen.right(), spacing);
  for (double i = west; i <= east; ++i) {
    const double x = camera.snapped(camera.toPixels({i * spacing, 0}).x() - width / 2);
    const QRectF line(x, inside.top(), width, inside.height());
    layer.rectangles.push_back(rectangleAt(line.intersected(inside), camera, color));
  }
  const auto [low, high] = multiplesWithin(seen.top(), seen.bottom(), spacing);
  for (double i = low; i <= high; ++i) {
    const double y = camera.snapped(camera.toPixels({0, i * spacing}).y() - width / 2);
    const QRectF line(inside.left(), y, inside.width(), width);
    layer.rectangles.push_back(rectangleAt(line.intersected(inside), camera, color));
  }
}

/// Puts numbers down where nothing else is.
class NumberPlacer {
 public:
  NumberPlacer(const RoomFrame& frame, double top, const Camera& camera, const SceneLook& look,
               Drawing& drawing)
      : m_camera(camera), m_look(look), m_drawing(drawing), m_inside(frame.inside) {
    m_allowed = viewportOf(camera);
    m_allowed.setTop(top);
    for (const QRectF& wall : {frame.floor, frame.ceiling, frame.west, frame.east})
      m_taken.push_back(wall);
  }

  void place(const QString& words, QRectF box) {
    const auto overlaps = [&box](const QRectF& other) { return box.intersects(other); };
    if (!m_allowed.contains(box)) return;
    if (std::any_of(m_taken.begin(), m_taken.end(), overlaps)) return;
    m_taken.push_back(box.adjusted(-kGap, -kGap / 4, kGap, kGap / 4));
    const QRgb plate = box.intersects(m_inside) ? withOpacity(m_look.theme.room, 0.85) : 0;
    m_drawing.texts.push_back({m_camera.toMetres(box.topLeft()), QPointF(0, 0), words, m_look.font,
                               m_look.theme.faintText.rgb(), plate});
  }

 private:
  const Camera& m_camera;
  const SceneLook& m_look;
  Drawing& m_drawing;
  QRectF m_inside;
  QRectF m_allowed;
  std::vector<QRectF> m_taken;
};

}  // namespace

Rectangle rectangleAt(QRectF pixels, const Camera& camera, QRgb color) {
  return {camera.toMetres(pixels.bottomLeft()), camera.toMetres(pixels.topRight()), color};
}

RoomFrame roomFrame(const core::Room& room, const Camera& camera) {
  const QPointF upperLeft = camera.toPixels({0, room.height});
  const QPointF lowerRight = camera.toPixels({room.width, 0});
  const QPointF a(camera.snapped(upperLeft.x()), camera.snapped(upperLeft.y()));
  const QPointF b(camera.snapped(lowerRight.x()), camera.snapped(lowerRight.y()));
  const QRectF inside(a, b);
  const double outerHeight = inside.height() + kWallWidth + kFloorWidth;
  RoomFrame frame;
  frame.inside = inside;
  frame.ceiling = QRectF(a.x(), a.y() - kWallWidth, inside.width(), kWallWidth);
  frame.floor = QRectF(a.x(), b.y(), inside.width(), kFloorWidth);
  frame.west = QRectF(a.x() - kWallWidth, a.y() - kWallWidth, kWallWidth, outerHeight);
  frame.east = QRectF(b.x(), a.y() - kWallWidth, kWallWidth, outerHeight);
  return frame;
}

Ruler roomRuler(const core::Room& room, const Camera& camera, const SceneLook& look) {
  const QRectF seen = seenPart(room, camera);
  const double extent = std::max({seen.right(), seen.bottom(), 1 / camera.scale()});
  Ruler ruler = rulerFor(kLeastSpacing / camera.scale(), extent);
  while (widthOf(ruler.textAt(extent), look.font) + 3 * kGap > ruler.spacing * camera.scale())
    ruler = rulerFor(1.5 * ruler.spacing, extent);
  return ruler;
}

void drawRoom(const core::Room& room, const Ruler& ruler, const Camera& camera,
              const SceneLook& look, Drawing& drawing) {
  const RoomFrame frame = roomFrame(room, camera);
  // Far outside of the picture lies nothing that a painter would have to cut away.
  const QRectF near = viewportOf(camera).adjusted(-16, -16, 16, 16);
  Layer& layer = drawing.layers[kRoomLayer];
  const auto add = [&](const QRectF& pixels, const QColor& color) {
    const QRectF seen = pixels.intersected(near);
    if (!seen.isEmpty()) layer.rectangles.push_back(rectangleAt(seen, camera, color.rgb()));
  };
  add(frame.inside, look.theme.room);
  const double fineSpacing = ruler.spacing / partsOf(ruler);
  if (fineSpacing * camera.scale() >= kLeastGridSpacing)
    addGrid(room, fineSpacing, camera, withOpacity(look.theme.grid, 0.45), layer);
  addGrid(room, ruler.spacing, camera, look.theme.grid.rgb(), layer);
  for (const QRectF& wall : {frame.ceiling, frame.west, frame.east, frame.floor})
    add(wall, look.theme.wall);
}

void drawNumbers(const core::Room& room, const Ruler& ruler, double top, const Camera& camera,
                 const SceneLook& look, Drawing& drawing) {
  const RoomFrame frame = roomFrame(room, camera);
  const QRectF seen = seenPart(room, camera);
  const double height = lineHeight(look.font);
  NumberPlacer placer(frame, top, camera, look, drawing);

  const double below =
      std::min(frame.floor.bottom() + kGap / 2, camera.viewport().height() - height - kGap / 2);
  const auto [west, east] = multiplesWithin(seen.left(), seen.right(), ruler.spacing);
  for (double i = west; i <= east; ++i) {
    const QString words = ruler.textAt(i * ruler.spacing);
    const double width = widthOf(words, look.font);
    const double x = camera.toPixels({i * ruler.spacing, 0}).x();
    placer.place(words, QRectF(x - width / 2, below, width, height));
  }
  const auto [low, high] = multiplesWithin(seen.top(), seen.bottom(), ruler.spacing);
  for (double i = low; i <= high; ++i) {
    const QString words = ruler.textAt(i * ruler.spacing);
    const double width = widthOf(words, look.font);
    const double left = std::max(frame.west.left() - kGap - width, kGap);
    const double y = camera.toPixels({0, i * ruler.spacing}).y();
    placer.place(words, QRectF(left, y - height / 2, width, height));
  }
}

}  // namespace ui
