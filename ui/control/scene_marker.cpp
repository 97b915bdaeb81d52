#include "ui/control/scene_marker.h"

#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/selection.h"
#include "ui/control/tool_box.h"
#include "ui/control/weight_mover.h"

namespace ui {

SceneMarker::SceneMarker(const Sources& sources, QObject* parent)
    : QObject(parent), m_sources(sources) {
  connect(sources.controller, &RunController::restarted, this, &SceneMarker::scaleArrows);
  connect(sources.controller, &RunController::timeShown, this, &SceneMarker::noteTime);
  connect(sources.controller, &RunController::playingChanged, this, &SceneMarker::noteTime);
  connect(sources.selection, &Selection::weightSelected, sources.mover, &WeightMover::forgetWords);
  connect(sources.selection, &Selection::weightSelected, this, &SceneMarker::mark);
  connect(sources.editor, &SceneEditor::draftChanged, this, &SceneMarker::mark);
  connect(sources.mover, &WeightMover::changed, this, &SceneMarker::mark);
  connect(sources.tools, &ToolBox::changed, this, &SceneMarker::mark);
}

void SceneMarker::showVelocities(bool shown) {
  m_marks.arrows.velocities = shown;
  mark();
}

void SceneMarker::showForces(bool shown) {
  m_marks.arrows.forces = shown;
  mark();
}

void SceneMarker::showTensions(bool shown) {
  m_marks.arrows.tensions = shown;
  mark();
}

/// While a velocity is dragged its arrow keeps its scale: it would run away from the hand.
void SceneMarker::scaleArrows() {
  if (m_sources.mover->isDragging()) return;
  m_marks.arrows.scales = arrowScales(m_sources.controller->scene());
  mark();
}

void SceneMarker::mark() {
  if (!m_sources.mover->isDragging())
    m_marks.arrows.scales = arrowScales(m_sources.controller->scene());
  m_marks.selection = selected();
  m_marks.tools = m_sources.tools->tools();
  emit marksChanged(m_marks);
}

/// Called in each frame: does nothing unless something is drawn otherwise.
void SceneMarker::noteTime() {
  if (!m_marks.selection) return;
  const bool isMovable = m_sources.mover->isAllowed();
  if (!isMovable) m_sources.mover->forgetWords();
  if (isMovable != m_marks.selection->isMovable) mark();
}

std::optional<ShownSelection> SceneMarker::selected() const {
  const std::optional<int> weight = m_sources.selection->weight();
  if (!m_sources.mover->weight()) return std::nullopt;
  ShownSelection shown{*weight, m_sources.mover->isAllowed(), {tr("Weight %1").arg(*weight + 1)}};
  shown.words += m_sources.mover->words();
  shown.rejected = rejected(static_cast<std::size_t>(*weight));
  return shown;
}

std::optional<core::Weight> SceneMarker::rejected(std::size_t index) const {
  if (m_sources.editor->problems().empty()) return std::nullopt;
  const core::Weight& drafted = *m_sources.mover->weight();
  const std::vector<core::Weight>& accepted = m_sources.editor->scene()->weights;
  const bool isSame = index < accepted.size() &&
                      core::startPosition(accepted[index]) == core::startPosition(drafted) &&
                      accepted[index].radius == drafted.radius;
  return isSame ? std::nullopt : std::optional(drafted);
}

}  // namespace ui
