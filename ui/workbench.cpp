#include "ui/workbench.h"

#include <QWidget>

#include "ui/control/draft_keeper.h"
#include "ui/control/event_navigator.h"
#include "ui/control/frame_ticker.h"
#include "ui/control/recovery.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/control/scene_target.h"
#include "ui/control/selection.h"
#include "ui/control/settings.h"
#include "ui/control/tool_box.h"
#include "ui/style/appearance.h"

namespace ui {

Workbench::Workbench(const core::Scene& scene, const QString& file, QWidget* window)
    : QObject(window),
      m_appearance(new Appearance(this)),
      m_editor(new SceneEditor(scene, this)),
      m_selection(new Selection(m_editor, this)),
      m_controller(new RunController(this)),
      m_events(new EventNavigator(m_controller, this)),
      m_ticker(new FrameTicker(this)),
      m_files(new SceneFiles(m_editor, file, window)),
      m_target(new SceneTarget(*m_editor->scene(), this)),
      m_tools(new ToolBox(this)) {
  m_appearance->setChoice(Settings().theme());
  m_appearance->setTextSize(Settings().textSize());
  connectRuns();
  connectTarget();
}

Workbench::~Workbench() = default;

void Workbench::connectRuns() {
  connect(m_ticker, &FrameTicker::ticked, m_controller, &RunController::passTime);
  connect(m_controller, &RunController::busyChanged, m_ticker, &FrameTicker::setRunning);
  connect(m_controller, &RunController::begun, m_tools, &ToolBox::restart);
  connect(m_editor, &SceneEditor::sceneReplaced, m_controller, &RunController::pause);
  connect(m_editor, &SceneEditor::sceneChanged, this, &Workbench::start);
}

void Workbench::connectTarget() {
  connect(m_editor, &SceneEditor::sceneChanged, m_target,
          [this] { m_target->fitInto(*m_editor->scene()); });
  // None selected: the one before stays.
  connect(m_selection, &Selection::weightSelected, m_target, &SceneTarget::setWeight);
}

void Workbench::start() {
  m_controller->setScene(m_editor->scene());
}

void Workbench::keepDraftsIn(const QString& folder) {
  m_drafts = new DraftKeeper(m_editor, folder, DraftKeeper::kUsualDelay, this);
  m_recovery = new Recovery(m_editor, m_files, m_drafts, folder, this);
}

}  // namespace ui
