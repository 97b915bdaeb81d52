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

bool SceneEditor::change(const Edit& edit, const Words& words, const QString& mergeKey) {
  const core::Scene before = m_draft;
  const ScenePointer ranBefore = ranBesideDraft();
  edit(m_draft);
  bool sceneIsOther = false;
  if (m_draft != before) {
    sceneIsOther = judge(m_scene);
    record(before, ranBefore, words, mergeKey);
  }
  tell(sceneIsOther, false);
  return m_problems.empty();
}

/// What runs while the draft cannot; null: the draft itself does.
SceneEditor::ScenePointer SceneEditor::ranBesideDraft() const {
  return m_problems.empty() ? nullptr : m_scene;
}

/// Lets the draft run if it can, else what ran beside it.
/// @return  whether what runs is not what ran before
bool SceneEditor::judge(const ScenePointer& ranBeside) {
  m_problems = core::problemsIn(m_draft);
  const core::Scene& next = m_problems.empty() ? m_draft : *ranBeside;
  if (next == *m_scene) return false;
  m_scene = m_problems.empty() ? std::make_shared<const core::Scene>(m_draft) : ranBeside;
  return true;
}

void SceneEditor::record(const core::Scene& before, const ScenePointer& ranBefore,
                         const Words& words, const QString& mergeKey) {
  if (UndoStep* last = m_history.stepToMergeWith(mergeKey)) {
    merge(*last, before);
  } else {
    add({words, mergeKey, SceneChange(before, m_draft), ranBefore, ranBesideDraft(), {}});
  }
}

/// Lets the last step lead to the draft; a drag that has come back to its start was none.
void SceneEditor::merge(UndoStep& last, core::Scene before) {
  last.change.undo(before);
  last.change = SceneChange(before, m_draft);
  last.ranAfter = ranBesideDraft();
  if (last.change.isEmpty()) m_history.dropLast();
}

void SceneEditor::add(UndoStep step) {
  forgetUndoneSave();
  m_history.add(std::move(step));
}

/// What was saved and then undone cannot be come back to once something else is done.
void SceneEditor::forgetUndoneSave() {
  if (m_origin.savedAt > m_history.position()) m_origin.savedAt.reset();
}

void SceneEditor::replace(core::Scene scene, const QString& file, const Words& words) {
  take(std::move(scene), file, words);
  m_origin = {file, m_history.position()};
  tell(true, true);
}

void SceneEditor::restore(core::Scene scene, const std::optional<core::Scene>& draft,
                          const QString& file, const Words& words) {
  take(std::move(scene), file, words);
  m_origin = {file, std::nullopt};
  tell(true, true);
  if (draft) change([&](core::Scene& present) { present = *draft; }, words);
}

void SceneEditor::take(core::Scene scene, const QString& file, const Words& words) {
  const core::Scene before = std::exchange(m_draft, withSolvers(std::move(scene)));
  const ScenePointer ranBefore = ranBesideDraft();
  judge(m_scene);
  if (m_draft != before || file != m_origin.file) {
    forgetUndoneSave();
    add({words, {}, SceneChange(before, m_draft), ranBefore, ranBesideDraft(), m_origin});
  }
}

/// Steps from the draft back to where it ran last; nothing if they are forgotten.
std::optional<int> SceneEditor::stepsBackToScene() const {
  if (m_problems.empty()) return 0;
  for (int back = 0;; ++back) {
    const UndoStep* step = m_history.stepBefore(back);
    if (!step) return std::nullopt;
    if (!step->ranBefore) return back + 1;
  }
}

void SceneEditor::giveUpDraft() {
  if (m_problems.empty()) return;
  const std::optional<int> steps = stepsBackToScene();
  if (!steps) {
    change([this](core::Scene& draft) { draft = *m_scene; });
    return;
  }
  m_history.closeStep();
  for (int i = 0; i < *steps; ++i) crossBack();
  tell(judge(m_scene), false);
}

void SceneEditor::setSavedAs(const QString& file) {
  m_history.closeStep();
  m_history.forgetSaved();
  m_origin.file = file;
  m_origin.savedAt.reset();
  if (const std::optional<int> steps = stepsBackToScene())
    m_origin.savedAt = m_history.position() - *steps;
  tellOrigin();
}

/// Changes the draft and its origin back to before the last step; it is not judged yet.
void SceneEditor::crossBack() {
  UndoStep& step = *m_history.undoStep();
  step.change.undo(m_draft);
  if (step.otherOrigin) std::swap(m_origin, *step.otherOrigin);
  m_history.move(-1);
}

void SceneEditor::undo() {
  m_history.closeStep();
  const UndoStep* step = m_history.undoStep();
  if (!step) return;
  crossBack();
  const bool sceneIsOther = judge(step->ranBefore);
  tell(sceneIsOther, step->otherOrigin.has_value());
}

void SceneEditor::redo() {
  UndoStep* step = m_history.redoStep();
  if (!step) return;
  step->change.redo(m_draft);
  if (step->otherOrigin) std::swap(m_origin, *step->otherOrigin);
  m_history.move(1);
  const bool sceneIsOther = judge(step->ranAfter);
  tell(sceneIsOther, step->otherOrigin.has_value());
}

QString SceneEditor::undoWords() const {
  const UndoStep* step = m_history.undoStep();
  return step ? step->words.text() : QString();
}

QString SceneEditor::redoWords() const {
  const UndoStep* step = m_history.redoStep();
  return step ? step->words.text() : QString();
}

/// Says what has become of the last change.
/// @param sceneIsOther  another scene runs
/// @param isReplaced    it is another one altogether
void SceneEditor::tell(bool sceneIsOther, bool isReplaced) {
  tellOrigin();
  if (isReplaced) emit sceneReplaced();
  if (sceneIsOther || isReplaced) emit sceneChanged();
  emit draftChanged();
  emit historyChanged();
}

void SceneEditor::tellOrigin() {
  if (m_wasModified != isModified()) emit modifiedChanged(m_wasModified = isModified());
  if (m_toldFile != m_origin.file) emit fileChanged(m_toldFile = m_origin.file);
}

}  // namespace ui
