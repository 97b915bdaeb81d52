#include "ui/control/selection.h"

#include "ui/control/scene_editor.h"

namespace ui {

Selection::Selection(const SceneEditor* editor, QObject* parent)
    : QObject(parent), m_editor(editor) {
  connect(editor, &SceneEditor::sceneReplaced, this, &Selection::clear);
  connect(editor, &SceneEditor::draftChanged, this, [this] { select(m_weight); });
}

std::optional<int> Selection::weight() const {
  if (m_weight == kNone) return std::nullopt;
  return m_weight;
}

void Selection::select(int weight) {
  const int selected = 0 <= weight && weight < count() ? weight : kNone;
  if (selected == m_weight) return;
  m_weight = selected;
  emit weightSelected(selected);
}

int Selection::count() const {
  return static_cast<int>(m_editor->draft().weights.size());
}

void Selection::selectBeside(int way) {
  const int all = count();
  if (all == 0) return;
  const int from = m_weight == kNone && way < 0 ? 0 : m_weight;
  select((from + way + all) % all);
}

}  // namespace ui
