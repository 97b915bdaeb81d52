#include "ui/view/measuring_tools.h"

#include <algorithm>
#include <cmath>

#include "ui/view/camera.h"
#include "ui/view/drawing.h"
#include "ui/view/scene_look.h"

namespace ui {

namespace {

constexpr double kReach = 12;       // around ends, within which they are taken hold of [px]
constexpr double kTapeReach = 7;    // likewise beside the tape [px]
constexpr double kGripRadius = 7;   // [px]
constexpr double kGripOutline = 2;  // [px]; twice that where chosen

double distance(QPointF a, QPointF b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

double distanceToStroke(QPointF point, QPointF from, QPointF to) {
  const QPointF way = to - from;
  const double square = QPointF::dotProduct(way, way);
  if (square == 0) return distance(point, from);
  const double share = std::clamp(QPointF::dotProduct(point - from, way) / square, 0.0, 1.0);
  return distance(point, from + share * way);
}

/// The place of a part that has one in the room.
Eigen::Vector2d inRoom(const MeasuringTools& tools, ToolPart part) {
  switch (part) {
    case ToolPart::kTapeFrom:
      return tools.tape->from;
    case ToolPart::kTapeTo:
      return tools.tape->to;
    case ToolPart::kTape:
      return (tools.tape->from + tools.tape->to) / 2;
    case ToolPart::kVertex:
      return tools.protractor->vertex;
    case ToolPart::kFirstArm:
      return tools.protractor->first;
    case ToolPart::kSecondArm:
      return tools.protractor->second;
    case ToolPart::kStopwatch:
      break;
  }
  return {0, 0};
}

/// What moves along with a part.
std::vector<Eigen::Vector2d*> movedWith(MeasuringTools& tools, ToolPart part) {
  switch (part) {
    case ToolPart::kTapeFrom:
      return {&tools.tape->from};
    case ToolPart::kTapeTo:
      return {&tools.tape->to};
    case ToolPart::kTape:
      return {&tools.tape->from, &tools.tape->to};
    case ToolPart::kVertex:
      return {&tools.protractor->vertex, &tools.protractor->first, &tools.protractor->second};
    case ToolPart::kFirstArm:
      return {&tools.protractor->first};
    case ToolPart::kSecondArm:
      return {&tools.protractor->second};
    case ToolPart::kStopwatch:
      break;
  }
  return {};
}

void addGrip(const Eigen::Vector2d& place, bool isChosen, const SceneLook& look, Layer& layer) {
  const QColor& color = isChosen ? look.theme.text : look.theme.lostToImpacts;
  layer.discs.push_back({place, 0, isChosen ? kGripRadius + 2 : kGripRadius,
                         isChosen ? 2 * kGripOutline : kGripOutline,
                         withOpacity(look.theme.room, 0.5), color.rgb()});
}

}  // namespace

std::vector<ToolPart> partsOf(const MeasuringTools& tools) {
  std::vector<ToolPart> parts;
  if (tools.tape) parts = {ToolPart::kTapeFrom, ToolPart::kTapeTo, ToolPart::kTape};
  if (tools.protractor)
    parts.insert(parts.end(), {ToolPart::kVertex, ToolPart::kFirstArm, ToolPart::kSecondArm});
  if (tools.stopwatch) parts.push_back(ToolPart::kStopwatch);
  return parts;
}

std::optional<ToolPart> toolPartAt(const MeasuringTools& tools, QPointF pixel, double top,
                                   const Camera& camera, const SceneLook& look) {
  if (tools.stopwatch && stopwatchFace(*tools.stopwatch, top, camera, look).contains(pixel))
    return ToolPart::kStopwatch;
  std::optional<ToolPart> nearest;
  double least = kReach;
  for (const ToolPart part : partsOf(tools)) {
    if (part == ToolPart::kStopwatch || part == ToolPart::kTape) continue;
    const double away = distance(pixel, camera.toPixels(inRoom(tools, part)));
    if (away > least) continue;
    least = away;
    nearest = part;
  }
  if (nearest || !tools.tape) return nearest;
  const double away =
      distanceToStroke(pixel, camera.toPixels(tools.tape->from), camera.toPixels(tools.tape->to));
  return away <= kTapeReach ? std::optional(ToolPart::kTape) : std::nullopt;
}

QPointF placeOf(const MeasuringTools& tools, ToolPart part, double top, const Camera& camera,
                const SceneLook& look) {
  if (part == ToolPart::kStopwatch)
    return stopwatchFace(*tools.stopwatch, top, camera, look).topLeft();
  return camera.toPixels(inRoom(tools, part));
}

void movePart(MeasuringTools& tools, ToolPart part, QPointF pixel, double top, const Camera& camera,
              const SceneLook& look) {
  if (part == ToolPart::kStopwatch)
    return placeStopwatch(*tools.stopwatch, pixel, top, camera, look);
  const Eigen::Vector2d way = camera.toMetres(pixel) - inRoom(tools, part);
  for (Eigen::Vector2d* place : movedWith(tools, part)) *place += way;
}

void drawTools(const MeasuringTools& tools, double time, double top, const Camera& camera,
               const SceneLook& look, Drawing& drawing) {
  if (tools.tape) drawTape(*tools.tape, camera, look, drawing);
  if (tools.protractor) drawProtractor(*tools.protractor, camera, look, drawing);
  for (const ToolPart part : partsOf(tools)) {
    const bool isChosen = part == tools.chosen;
    if (part == ToolPart::kStopwatch)
      drawStopwatch(*tools.stopwatch, time, isChosen, top, camera, look, drawing);
    else if (part != ToolPart::kTape || isChosen)
      addGrip(inRoom(tools, part), isChosen, look, drawing.layers[kToolLayer]);
  }
}

}  // namespace ui
