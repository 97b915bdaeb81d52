#include "ui/control/scene_editor.h"

#include <utility>

namespace ui {
namespace {

/// A scene that names no runs shows what the program is for: Runge–Kutta beside Euler.
core::Scene withSolvers(core::Scene scene) {
  if (scene.solvers.empty()) {
    scene.solvers = {core::Solver{.method = "rk4"}, core::Solver{.method = "euler"}};
  }
  return scene;
}

}  // namespace

SceneEditor::SceneEditor(core::Scene scene, QObject* parent)
    : QObject(parent), m_draft(withSolvers(std::move(scene))) {
  m_scene = std::make_shared<const core::Scene>(m_draft);
}

bool SceneEditor::change(const std::function<void(core::Scene&)>& edit) {
  edit(m_draft);
  m_problems = core::problemsIn(m_draft);
  const bool canRun = m_problems.empty();
  if (canRun) accept();
  emit draftChanged();
  return canRun;
}

void SceneEditor::accept() {
  m_scene = std::make_shared<const core::Scene>(m_draft);
  setModified(true);
  emit sceneChanged();
}

void SceneEditor::replace(core::Scene scene) {
  m_draft = withSolvers(std::move(scene));
  m_scene = std::make_shared<const core::Scene>(m_draft);
  m_problems.clear();
  setModified(false);
  emit sceneReplaced();
  emit sceneChanged();
  emit draftChanged();
}

void SceneEditor::giveUpDraft() {
  if (m_problems.empty()) return;
  m_draft = *m_scene;
  m_problems.clear();
  emit draftChanged();
}

void SceneEditor::setModified(bool modified) {
  if (modified == m_modified) return;
  m_modified = modified;
  emit modifiedChanged(modified);
}

}  // namespace ui
