#pragma once

#include <QRectF>

#include "core/scene/scene.h"
#include "ui/view/drawing.h"
#include "ui/view/ruler.h"

namespace ui {

class Camera;
struct SceneLook;

/// Where the room's inside and its walls lie on the screen [px], edges between device pixels.
struct RoomFrame {
  QRectF inside;
  QRectF floor;
  QRectF ceiling;
  QRectF west;
  QRectF east;
};
RoomFrame roomFrame(const core::Room& room, const Camera& camera);

/// The ruler whose numbers fit side by side along the walls of this picture.
Ruler roomRuler(const core::Room& room, const Camera& camera, const SceneLook& look);

/// Adds the room: its ground, a grid with the ruler's spacing, walls, and a solid floor.
void drawRoom(const core::Room& room, const Ruler& ruler, const Camera& camera,
              const SceneLook& look, Drawing& drawing);

/// Adds the numbers along floor and west wall; along the edges of the picture where floor or
/// wall are not seen. None overlaps another one or a wall.
/// @param top  above this line are none [px]
void drawNumbers(const core::Room& room, const Ruler& ruler, double top, const Camera& camera,
                 const SceneLook& look, Drawing& drawing);

/// The rectangle in metres that covers these pixels.
Rectangle rectangleAt(QRectF pixels, const Camera& camera, QRgb color);

}  // namespace ui
