#include "ui/control/scene_commands.h"

#include <QAction>

#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_grasp.h"
#include "ui/control/scene_marker.h"
#include "ui/control/selection.h"
#include "ui/control/tool_box.h"
#include "ui/control/weight_mover.h"
#include "ui/view/scene_area.h"

namespace ui {
namespace {

struct Direction {
  Command move;
  Command accelerate;
  double x;
  double y;
};

constexpr Direction kDirections[] = {
    {Command::kMoveLeft, Command::kAccelerateLeft, -1, 0},
    {Command::kMoveRight, Command::kAccelerateRight, 1, 0},
    {Command::kMoveUp, Command::kAccelerateUp, 0, 1},
    {Command::kMoveDown, Command::kAccelerateDown, 0, -1},
};

}  // namespace

SceneCommands::SceneCommands(const Commands& commands, const Subject& subject, QObject* parent)
    : QObject(parent),
      m_commands(commands),
      m_subject(subject),
      m_mover(new WeightMover(subject.editor, subject.selection, subject.controller, this)),
      m_tools(subject.tools),
      m_grasp(new SceneGrasp(subject.selection, m_mover, m_tools, this)),
      m_marker(new SceneMarker(
          {subject.editor, subject.selection, subject.controller, m_mover, m_tools}, this)) {
  connectSelection();
  connectMoves();
  connectArrows();
  connectTools();
  connect(m_marker, &SceneMarker::marksChanged, subject.area, &SceneArea::setMarks);
  connect(m_mover, &WeightMover::changed, this, &SceneCommands::noteDragging);
  connect(m_grasp, &SceneGrasp::heldFast, this, [this] {
    emit said(tr("Weights can be moved at the start: press Home, or R for a reset"));
  });
  subject.area->setHand(m_grasp);
  offerWhatCanBeDone();
}

bool SceneCommands::isDragging() const {
  return m_mover->isDragging();
}

const SceneMarks& SceneCommands::marks() const {
  return m_marker->marks();
}

void SceneCommands::connectSelection() {
  const auto on = [this](Command command, auto* receiver, auto slot) {
    connect(m_commands.action(command), &QAction::triggered, receiver, slot);
  };
  on(Command::kNextWeight, m_subject.selection, &Selection::selectNext);
  on(Command::kPreviousWeight, m_subject.selection, &Selection::selectPrevious);
  on(Command::kDeselect, this, &SceneCommands::deselect);
  // Keys move either a weight or a part of a tool.
  connect(m_subject.selection, &Selection::weightSelected, this, [this](int weight) {
    if (weight >= 0) m_tools->choose(std::nullopt);
  });
  connect(m_subject.selection, &Selection::weightSelected, this,
          &SceneCommands::offerWhatCanBeDone);
  connect(m_tools, &ToolBox::changed, this, &SceneCommands::offerWhatCanBeDone);
  connect(m_subject.controller, &RunController::busyChanged, this,
          &SceneCommands::offerWhatCanBeDone);
  connect(m_subject.controller, &RunController::restarted, this,
          &SceneCommands::offerWhatCanBeDone);
}

void SceneCommands::connectMoves() {
  for (const Direction& way : kDirections) {
    connect(m_commands.action(way.move), &QAction::triggered, this, [this, way] {
      if (m_tools->tools().chosen)
        m_tools->moveBy(way.x, way.y, *m_subject.area->views().front());
      else
        m_mover->moveBy(way.x, way.y);
    });
    connect(m_commands.action(way.accelerate), &QAction::triggered, m_mover,
            [this, way] { m_mover->accelerateBy(way.x, way.y); });
  }
}

void SceneCommands::connectArrows() {
  const auto on = [this](Command command, auto slot) {
    connect(m_commands.action(command), &QAction::toggled, m_marker, slot);
  };
  on(Command::kVelocities, &SceneMarker::showVelocities);
  on(Command::kForces, &SceneMarker::showForces);
  on(Command::kTensions, &SceneMarker::showTensions);
}

void SceneCommands::connectTools() {
  const auto on = [this](Command command, auto slot) {
    connect(m_commands.action(command), &QAction::triggered, this, slot);
  };
  const auto view = [this]() -> const SceneView& { return *m_subject.area->views().front(); };
  connect(m_commands.action(Command::kTape), &QAction::toggled, this,
          [this, view](bool shown) { m_tools->showTape(shown, view()); });
  connect(m_commands.action(Command::kProtractor), &QAction::toggled, this,
          [this, view](bool shown) { m_tools->showProtractor(shown, view()); });
  QAction* stopwatch = m_commands.action(Command::kStopwatch);
  connect(stopwatch, &QAction::toggled, m_tools, &ToolBox::showStopwatch);
  const auto startOrStop = [this, stopwatch] {
    stopwatch->setChecked(true);
    m_tools->startOrStop(m_subject.controller->time());
  };
  on(Command::kStartStopwatch, startOrStop);
  connect(m_grasp, &SceneGrasp::stopwatchClicked, this, startOrStop);
  on(Command::kZeroStopwatch, [this] { m_tools->setToZero(m_subject.controller->time()); });
  on(Command::kNextToolPart, [this] { m_tools->chooseNext(); });
}

/// One thing after the other: what is dragged, the part of a tool, the weight.
void SceneCommands::deselect() {
  if (m_mover->isDragging())
    m_mover->cancel();
  else if (m_tools->tools().chosen)
    m_tools->choose(std::nullopt);
  else
    m_subject.selection->clear();
}

void SceneCommands::offerWhatCanBeDone() {
  const auto offer = [this](Command command, bool isOffered) {
    m_commands.action(command)->setEnabled(isOffered);
  };
  const bool isSelected = m_subject.selection->weight().has_value();
  const MeasuringTools& tools = m_tools->tools();
  for (const Direction& way : kDirections) {
    offer(way.move, isSelected || tools.chosen);
    offer(way.accelerate, isSelected && !tools.chosen);
  }
  // While travelling the same key stops that.
  offer(Command::kDeselect, (isSelected || tools.chosen) && !m_subject.controller->isTravelling());
  const bool hasWeights = !m_subject.editor->draft().weights.empty();
  offer(Command::kNextWeight, hasWeights);
  offer(Command::kPreviousWeight, hasWeights);
  offer(Command::kZeroStopwatch, tools.stopwatch.has_value());
  offer(Command::kNextToolPart, !partsOf(tools).empty());
}

void SceneCommands::noteDragging() {
  if (isDragging() == m_wasDragging) return;
  m_wasDragging = isDragging();
  emit draggingChanged(m_wasDragging);
}

}  // namespace ui
