#pragma once

#include <QObject>
#include <QString>

#include "core/scene/scene.h"

class QWidget;

namespace ui {

class Appearance;
class DraftKeeper;
class EventNavigator;
class FrameTicker;
class Recovery;
class RunController;
class SceneEditor;
class SceneFiles;
class SceneTarget;
class Selection;
class ToolBox;

/// What a window works on, and what goes on while its widgets are built anew for another
/// language: the scene with its history and its files, the runs with their records, what is
/// selected, the target and the tools that lie on the scene, the draft that is kept for a crash.
class Workbench : public QObject {
  Q_OBJECT

 public:
  /// @param scene   shown first; its runs are there once start() was called
  /// @param file    where it came from; empty: built in
  /// @param window  over which questions and messages appear, and the parent
  Workbench(const core::Scene& scene, const QString& file, QWidget* window);
  ~Workbench() override;

  /// Makes the runs of the first scene; call once somebody listens.
  void start();

  /// Keeps what is not saved in this folder from now on, and can bring back what others have
  /// left there.
  void keepDraftsIn(const QString& folder);

  Appearance* appearance() const { return m_appearance; }
  SceneEditor* editor() const { return m_editor; }
  Selection* selection() const { return m_selection; }
  RunController* controller() const { return m_controller; }
  EventNavigator* events() const { return m_events; }
  SceneFiles* files() const { return m_files; }
  SceneTarget* target() const { return m_target; }
  ToolBox* tools() const { return m_tools; }
  /// Null while nothing is kept.
  DraftKeeper* drafts() const { return m_drafts; }
  Recovery* recovery() const { return m_recovery; }

 private:
  void connectRuns();
  void connectTarget();

  Appearance* m_appearance;
  SceneEditor* m_editor;
  Selection* m_selection;
  RunController* m_controller;
  EventNavigator* m_events;
  FrameTicker* m_ticker;
  SceneFiles* m_files;
  SceneTarget* m_target;
  ToolBox* m_tools;
  DraftKeeper* m_drafts = nullptr;
  Recovery* m_recovery = nullptr;
};

}  // namespace ui
