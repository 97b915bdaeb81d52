#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <QObject>

#include "core/scene/scene.h"
#include "core/scene/scene_limits.h"

namespace ui {

/// The scene while the user changes it.
///
/// Changes go into a draft. A draft that can run becomes the scene at once; one that cannot
/// stays a draft, with its problems, until a further change mends it or it is given up: what
/// runs goes on, and nothing the user entered is lost.
class SceneEditor : public QObject {
  Q_OBJECT

 public:
  /// @pre as for replace()
  explicit SceneEditor(core::Scene scene, QObject* parent = nullptr);

  /// What runs.
  const std::shared_ptr<const core::Scene>& scene() const { return m_scene; }
  /// What the forms show.
  const core::Scene& draft() const { return m_draft; }
  /// Why the draft cannot run; empty when it is the scene.
  const std::vector<core::Problem>& problems() const { return m_problems; }

  /// True when the scene is not what was opened or saved last.
  bool isModified() const { return m_modified; }
  void setSaved() { setModified(false); }

  /// Changes the draft.
  /// @return  whether it has become the scene
  bool change(const std::function<void(core::Scene&)>& edit);

  /// Takes another scene, unmodified.
  /// @pre problemsIn(scene) is empty, and its solvers' methods are known
  void replace(core::Scene scene);

  /// Makes the draft the scene that runs again.
  void giveUpDraft();

 signals:
  /// Another scene runs from now on: a changed one, or another one altogether.
  void sceneChanged();
  /// The scene is another one altogether: what was typed for the old one is void.
  void sceneReplaced();
  /// The draft, or what is wrong with it, is not what it was.
  void draftChanged();
  void modifiedChanged(bool modified);

 private:
  void setModified(bool modified);
  void accept();

  std::shared_ptr<const core::Scene> m_scene;
  core::Scene m_draft;
  std::vector<core::Problem> m_problems;
  bool m_modified = false;
};

}  // namespace ui
