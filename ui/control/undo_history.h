#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>

#include <QString>

#include "ui/control/scene_change.h"
#include "ui/control/words.h"

namespace ui {

/// Where a scene belongs, and when it was what is stored there.
struct SceneOrigin {
  QString file;  ///< empty: none yet
  /// The position in the history at which the scene was opened or saved; nothing: a state
  /// that can no longer be come back to.
  std::optional<int> savedAt;
};

/// One thing that was done, as the user sees it.
struct UndoStep {
  Words words;       ///< what was done: "change of length"; may be empty
  QString mergeKey;  ///< later changes with the same key belong to this step; empty: none do
  SceneChange change;
  /// What ran where the draft could not; null: the draft itself did.
  std::shared_ptr<const core::Scene> ranBefore;
  std::shared_ptr<const core::Scene> ranAfter;
  /// The origin on the other side of the step; nothing: the same one.
  std::optional<SceneOrigin> otherOrigin;
};

/// The steps that can be undone, and those that can be done again. Keeps as many as fit into
/// its memory, and always the latest.
class UndoHistory {
 public:
  static constexpr std::size_t kUsualBytes = std::size_t{256} << 20;

  /// @param mostBytes  memory of all steps together, about
  explicit UndoHistory(std::size_t mostBytes = kUsualBytes) : m_mostBytes(mostBytes) {}

  /// How many steps lie behind since the history began, forgotten ones too.
  int position() const { return m_forgotten + m_undoable; }

  /// The step to take back next, or to do again; null: there is none.
  UndoStep* undoStep() { return stepAt(m_undoable - 1); }
  UndoStep* redoStep() { return stepAt(m_undoable); }
  const UndoStep* undoStep() const { return stepBefore(0); }
  const UndoStep* redoStep() const { return stepBefore(-1); }
  /// The step to take back after `back` others; null: it is forgotten.
  const UndoStep* stepBefore(int back) const;
  /// The last step, if a change with this key belongs to it.
  UndoStep* stepToMergeWith(const QString& mergeKey);

  /// Adds a step that was just done; what was undone before it is forgotten.
  void add(UndoStep step);
  /// Forgets the last step, which has come to nothing.
  /// @pre undoStep(), and no redoStep()
  void dropLast();
  /// Moves over one step; applying it is the caller's affair.
  /// @pre undoStep() for a step back, redoStep() for one forward
  void move(int by) { m_undoable += by; }
  /// Further changes are a step of their own.
  void closeStep();
  /// A file was written: it may be one of those on the other sides of steps, so that nobody
  /// knows any more whether those are as they were stored.
  void forgetSaved();

 private:
  UndoStep* stepAt(int index);
  void limit();

  std::size_t m_mostBytes;
  std::deque<UndoStep> m_steps;
  int m_undoable = 0;   // the first of the steps; the others can be redone
  int m_forgotten = 0;  // steps before the first
};

}  // namespace ui
