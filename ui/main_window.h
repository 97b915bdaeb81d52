#pragma once

#include <QMainWindow>
#include <QString>

#include "core/scene/scene.h"
#include "ui/control/translations.h"

namespace ui {

class ChartsPanel;
class Commands;
class Exports;
class Presentation;
class RunController;
class SceneArea;
class SceneEditor;
class SceneFiles;
class Selection;
class TargetControl;
class WindowFace;
class WindowMemory;
class Workbench;

/// The window: a workbench, and a face in the language that the program speaks.
///
/// What the accessors of widgets and actions give lives until the next speak(); what is worked
/// on lives as long as the window.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// @param scene  shown first
  /// @param file   where it came from; empty: built in
  /// @pre problemsIn(scene) is empty, and its solvers' methods are known
  explicit MainWindow(const core::Scene& scene, const QString& file = {},
                      QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Keeps what is not saved in this folder from now on, and offers what others have left there.
  void keepDraftsIn(const QString& folder);

  /// Lets the whole program speak this language from now on, also at the next start. The widgets
  /// are built anew: what is worked on, runs and all, goes on as it is.
  void speak(Language language);

  RunController* controller() const;
  SceneEditor* editor() const;
  Selection* selection() const;
  SceneFiles* files() const;
  Exports* exports() const;
  const Commands& commands() const;
  ChartsPanel* charts() const;
  Presentation* presentation() const;
  TargetControl* target() const;

 protected:
  void closeEvent(QCloseEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  WindowMemory memory();
  void takeUsualSize();
  void makeFace();
  void removeFace();
  void sizePanels();

  Workbench* m_bench;
  SceneArea* m_area;
  WindowFace* m_face = nullptr;
  bool m_panelsSized = false;  // once: from then on the user decides
};

}  // namespace ui
