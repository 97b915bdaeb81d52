#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>

#include "core/scene/scene.h"
#include "core/scene/scene_limits.h"
#include "ui/control/undo_history.h"

namespace ui {

/// The scene while the user changes it, with all that can be undone and done again.
///
/// Changes go into a draft. A draft that can run becomes the scene at once; one that cannot
/// stays a draft, with its problems, until a further change mends it or it is given up: what
/// runs goes on, and nothing the user entered is lost. Undo leads through drafts, too, and
/// back over the opening of another scene.
class SceneEditor : public QObject {
  Q_OBJECT

 public:
  using Edit = std::function<void(core::Scene&)>;

  /// @pre as for replace()
  explicit SceneEditor(core::Scene scene, QObject* parent = nullptr);

  /// What runs.
  const std::shared_ptr<const core::Scene>& scene() const { return m_scene; }
  /// What the forms show.
  const core::Scene& draft() const { return m_draft; }
  /// Why the draft cannot run; empty when it is the scene.
  const std::vector<core::Problem>& problems() const { return m_problems; }

  /// Where the scene is saved; empty while it has no file.
  const QString& file() const { return m_origin.file; }
  /// True when the draft is not what was opened or saved last.
  bool isModified() const { return m_origin.savedAt != m_history.position(); }
  /// The scene, not a draft that cannot run, is now in this file.
  void setSavedAs(const QString& file);
  void setSaved() { setSavedAs(QString(m_origin.file)); }

  /// Changes the draft, as a step of its own that can be undone.
  ///
  /// @param words     what is done, such as "change of length", for the menu: "Undo …"
  /// @param mergeKey  joins changes into one step while they follow each other with the same
  ///                  key, such as those of one drag, until closeStep()
  /// @return          whether the draft has become the scene
  bool change(const Edit& edit, const Words& words = {}, const QString& mergeKey = {});
  /// The drag or the like is over: a further one is a step of its own.
  void closeStep() { m_history.closeStep(); }

  /// Takes another scene, unmodified. That too can be undone.
  /// @param file   where it is saved; empty: nowhere
  /// @param words  as for change()
  /// @pre problemsIn(scene) is empty, and its solvers' methods are known
  void replace(core::Scene scene, const QString& file = {}, const Words& words = {});

  /// Takes a scene that was not saved, modified, with a draft beside it that may not be able
  /// to run.
  /// @pre as for replace(), for `scene`
  void restore(core::Scene scene, const std::optional<core::Scene>& draft, const QString& file,
               const Words& words);

  /// Makes the scene that runs the draft again.
  void giveUpDraft();

  bool canUndo() const { return m_history.undoStep() != nullptr; }
  bool canRedo() const { return m_history.redoStep() != nullptr; }
  /// What would be undone or done again, such as "change of length"; may be empty.
  QString undoWords() const;
  QString redoWords() const;

 public slots:
  /// Takes back the last step; does nothing where there is none.
  void undo();
  void redo();

 signals:
  /// Another scene runs from now on: a changed one, or another one altogether.
  void sceneChanged();
  /// The scene is another one altogether: what was typed for the old one is void.
  void sceneReplaced();
  /// The draft, or what is wrong with it, is not what it was.
  void draftChanged();
  void modifiedChanged(bool modified);
  void fileChanged(const QString& file);
  /// What can be undone or done again is not what it was.
  void historyChanged();

 private:
  using ScenePointer = std::shared_ptr<const core::Scene>;

  void take(core::Scene scene, const QString& file, const Words& words);
  ScenePointer ranBesideDraft() const;
  bool judge(const ScenePointer& ranBeside);
  void record(const core::Scene& before, const ScenePointer& ranBefore, const Words& words,
              const QString& mergeKey);
  void merge(UndoStep& last, core::Scene before);
  void add(UndoStep step);
  void forgetUndoneSave();
  std::optional<int> stepsBackToScene() const;
  void crossBack();
  void tell(bool sceneIsOther, bool isReplaced);
  void tellOrigin();

  ScenePointer m_scene;
  core::Scene m_draft;
  std::vector<core::Problem> m_problems;
  UndoHistory m_history;
  SceneOrigin m_origin{{}, 0};

  // As last told.
  bool m_wasModified = false;
  QString m_toldFile;
};

}  // namespace ui
