#include "ui/control/scene_grasp.h"

#include "ui/control/selection.h"
#include "ui/control/tool_box.h"
#include "ui/control/weight_mover.h"
#include "ui/view/picking.h"
#include "ui/view/scene_view.h"
#include "ui/view/shown_scene.h"

namespace ui {

namespace {

std::optional<int> weightAt(const SceneView& view, QPointF pixel) {
  return weightNear(view.shown(), view.camera(), pixel);
}

}  // namespace

SceneGrasp::SceneGrasp(Selection* selection, WeightMover* mover, ToolBox* tools, QObject* parent)
    : QObject(parent), m_selection(selection), m_mover(mover), m_tools(tools) {}

/// Weights under the tape, which is long, come before it; ends of tools before weights.
bool SceneGrasp::isTool(const SceneView& view, QPointF pixel) const {
  const std::optional<ToolPart> part = m_tools->partAt(view, pixel);
  return part && (part != ToolPart::kTape || !weightAt(view, pixel));
}

SceneHand::Touch SceneGrasp::touch(const SceneView& view, QPointF pixel) {
  if (isTool(view, pixel)) {
    m_tools->choose(m_tools->partAt(view, pixel));
    m_tools->begin(view, pixel);
    return Touch::kHeld;
  }
  m_tools->choose(std::nullopt);
  std::optional<WeightMover::Grip> grip = m_mover->gripAt(view, pixel);
  if (!grip) {
    const std::optional<int> weight = weightAt(view, pixel);
    if (!weight) return Touch::kNothing;
    m_selection->select(*weight);
    if (!m_mover->isAllowed()) return Touch::kTouched;
    grip = WeightMover::Grip::kBody;
  }
  m_mover->begin(*grip, view, pixel);
  return Touch::kHeld;
}

void SceneGrasp::drag(const SceneView& view, QPointF pixel, Qt::KeyboardModifiers modifiers) {
  if (m_mover->isDragging())
    m_mover->drag(view, pixel, modifiers);
  else
    m_tools->drag(view, pixel, modifiers.testFlag(Qt::ControlModifier));
}

void SceneGrasp::release(Touch touch, bool moved) {
  const bool heldWeight = m_mover->isDragging();
  m_mover->end();
  if (touch == Touch::kNothing && !moved) m_selection->clear();
  if (touch == Touch::kTouched && moved) emit heldFast();
  const bool heldWatch = m_tools->tools().chosen == ToolPart::kStopwatch && !heldWeight;
  if (touch == Touch::kHeld && heldWatch && !moved) emit stopwatchClicked();
}

SceneHand::Touch SceneGrasp::feel(const SceneView& view, QPointF pixel) const {
  if (isTool(view, pixel) || m_mover->gripAt(view, pixel)) return Touch::kHeld;
  if (!weightAt(view, pixel)) return Touch::kNothing;
  return m_mover->isAllowed() ? Touch::kHeld : Touch::kTouched;
}

}  // namespace ui
