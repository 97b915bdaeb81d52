#include "ui/control/tool_box.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "ui/control/weight_drag.h"
#include "ui/view/camera.h"
#include "ui/view/scene_drawing.h"
#include "ui/view/scene_view.h"
#include "ui/view/shown_scene.h"

namespace ui {

namespace {

constexpr double kSnapReach = 14;  // around pivots and weights [px]
constexpr double kWatchStep = 20;  // by which keys move the stopwatch [px]

double topOf(const SceneView& view) {
  return wordsTop(view.shown(), view.camera(), view.look());
}

QRectF seenRoom(const SceneView& view) {
  const core::Room& room = view.shown().scene.room;
  const QRectF whole(0, 0, room.width, room.height);
  const QRectF seen = whole.intersected(view.camera().visibleMetres());
  return seen.isEmpty() ? whole : seen;
}

/// A place in the seen part of the room, at these shares of its width and height.
Eigen::Vector2d placeIn(const QRectF& room, double x, double y, const HandSteps& steps) {
  const double grain = kSnapSteps * steps.length;
  return {roundedTo(room.x() + x * room.width(), grain),
          roundedTo(room.y() + y * room.height(), grain)};
}

bool isSeen(const QRectF& room, std::initializer_list<Eigen::Vector2d> places) {
  return std::ranges::any_of(places, [&](const Eigen::Vector2d& place) {
    return room.contains(QPointF(place.x(), place.y()));
  });
}

MeasuringTape newTape(const SceneView& view) {
  const QRectF room = seenRoom(view);
  const HandSteps steps = handSteps(view.shown().scene.room);
  return {placeIn(room, 0.3, 0.3, steps), placeIn(room, 0.6, 0.3, steps)};
}

Protractor newProtractor(const SceneView& view) {
  const QRectF room = seenRoom(view);
  const HandSteps steps = handSteps(view.shown().scene.room);
  const Eigen::Vector2d vertex = placeIn(room, 0.5, 0.45, steps);
  const double arm = 0.25 * std::min(room.width(), room.height());
  return {vertex, vertex + Eigen::Vector2d(arm, 0), vertex + arm * Eigen::Vector2d(0.6, 0.8)};
}

/// The pivot or weight next to a pixel; nothing within reach: none.
std::optional<QPointF> thingNear(const SceneView& view, QPointF pixel) {
  std::optional<QPointF> nearest;
  double least = kSnapReach;
  const auto consider = [&](const Eigen::Vector2d& place) {
    const QPointF at = view.camera().toPixels(place);
    const double away = std::hypot(at.x() - pixel.x(), at.y() - pixel.y());
    if (away > least) return;
    least = away;
    nearest = at;
  };
  for (const core::Weight& weight : view.shown().scene.weights)
    if (weight.rope) consider(weight.rope->pivot);
  for (const ShownRun& run : view.shown().runs)
    for (const core::WeightState& state : run.weights) consider(state.position);
  return nearest;
}

QPointF snapped(const SceneView& view, QPointF pixel) {
  if (const std::optional<QPointF> thing = thingNear(view, pixel)) return *thing;
  const Eigen::Vector2d place = view.camera().toMetres(pixel);
  const double grain = kSnapSteps * handSteps(view.shown().scene.room).length;
  return view.camera().toPixels({roundedTo(place.x(), grain), roundedTo(place.y(), grain)});
}

}  // namespace

void ToolBox::showTape(bool shown, const SceneView& view) {
  if (!m_tape || !isSeen(seenRoom(view), {m_tape->from, m_tape->to})) m_tape = newTape(view);
  if (m_tools.tape) m_tape = m_tools.tape;
  m_tools.tape = shown ? m_tape : std::nullopt;
  choose(std::nullopt);
  emit changed();
}

void ToolBox::showProtractor(bool shown, const SceneView& view) {
  if (!m_protractor ||
      !isSeen(seenRoom(view), {m_protractor->vertex, m_protractor->first, m_protractor->second}))
    m_protractor = newProtractor(view);
  if (m_tools.protractor) m_protractor = m_tools.protractor;
  m_tools.protractor = shown ? m_protractor : std::nullopt;
  choose(std::nullopt);
  emit changed();
}

void ToolBox::showStopwatch(bool shown) {
  if (m_tools.stopwatch) m_stopwatch = m_tools.stopwatch;
  m_tools.stopwatch = shown ? std::optional(m_stopwatch.value_or(Stopwatch())) : std::nullopt;
  choose(std::nullopt);
  emit changed();
}

std::optional<ToolPart> ToolBox::partAt(const SceneView& view, QPointF pixel) const {
  return toolPartAt(m_tools, pixel, topOf(view), view.camera(), view.look());
}

void ToolBox::choose(std::optional<ToolPart> part) {
  if (part == m_tools.chosen) return;
  m_tools.chosen = part;
  emit changed();
}

void ToolBox::chooseNext() {
  const std::vector<ToolPart> parts = partsOf(m_tools);
  if (parts.empty()) return;
  if (!m_tools.chosen) return choose(parts.front());
  const auto next = std::ranges::find(parts, *m_tools.chosen) + 1;
  choose(next == parts.end() ? std::nullopt : std::optional(*next));
}

void ToolBox::begin(const SceneView& view, QPointF pixel) {
  m_offset = placeOf(m_tools, *m_tools.chosen, topOf(view), view.camera(), view.look()) - pixel;
}

void ToolBox::drag(const SceneView& view, QPointF pixel, bool snaps) {
  if (!m_tools.chosen) return;
  const bool isInRoom = m_tools.chosen != ToolPart::kStopwatch;
  const QPointF place = pixel + m_offset;
  movePart(m_tools, *m_tools.chosen, snaps && isInRoom ? snapped(view, place) : place, topOf(view),
           view.camera(), view.look());
  emit changed();
}

void ToolBox::moveBy(double x, double y, const SceneView& view) {
  if (!m_tools.chosen) return;
  const double step = m_tools.chosen == ToolPart::kStopwatch
                          ? kWatchStep
                          : handSteps(view.shown().scene.room).length * view.camera().scale();
  const QPointF place = placeOf(m_tools, *m_tools.chosen, topOf(view), view.camera(), view.look());
  movePart(m_tools, *m_tools.chosen, place + step * QPointF(x, -y), topOf(view), view.camera(),
           view.look());
  emit changed();
}

void ToolBox::startOrStop(double time) {
  if (!m_tools.stopwatch) return;
  m_tools.stopwatch->startOrStop(time);
  emit changed();
}

void ToolBox::setToZero(double time) {
  if (!m_tools.stopwatch) return;
  m_tools.stopwatch->setToZero(time);
  emit changed();
}

void ToolBox::restart() {
  if (m_tools.stopwatch && m_tools.stopwatch->isRunning()) setToZero(0);
}

}  // namespace ui
