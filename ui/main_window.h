#pragma once

#include <QMainWindow>
#include <QString>

#include "core/scene/scene.h"

class QDockWidget;
class QLabel;

namespace ui {

class Appearance;
class ChartsPanel;
class Commands;
class CutWindow;
class DraftKeeper;
class EventNavigator;
class Exports;
class FrameTicker;
class LessonGuide;
class MainMenu;
class MessageBar;
class PlaybackBar;
class Presentation;
class PresentationHeader;
class RunController;
class SceneArea;
class SceneCommands;
class SceneEditor;
class SceneFiles;
class Selection;
class TargetControl;
class TradeWindow;
class WindowMemory;

/// The window: the scene in the middle, forms at its side, charts below. Puts the
/// parts together and passes on what they say; each part does its own work.
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

  RunController* controller() const { return m_controller; }
  SceneEditor* editor() const { return m_editor; }
  Selection* selection() const { return m_selection; }
  SceneFiles* files() const { return m_files; }
  Exports* exports() const { return m_exports; }
  const Commands& commands() const { return *m_commands; }
  ChartsPanel* charts() const { return m_charts; }
  Presentation* presentation() const { return m_presentation; }
  TargetControl* target() const { return m_target; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  WindowMemory memory();
  void buildCentre();
  void buildPanels();
  QDockWidget* addPanel(Qt::DockWidgetArea area, const QString& name, const QString& title,
                        QWidget* content);
  void sizePanels();
  void buildMenus();
  void buildStatusBar();
  void connectPlayback();
  void connectScene();
  void connectFiles();
  void connectView();
  void preparePresentation();
  void connectTarget();

  void startScene();
  void showTime(double time);
  void showStopped();
  void showProblems();
  void showTitle();
  void showPainter();
  void changeSpeed(int steps);
  void showTrade();
  void showWhenToCut();

  Appearance* m_appearance;
  SceneEditor* m_editor;
  Selection* m_selection;
  RunController* m_controller;
  EventNavigator* m_events;
  FrameTicker* m_ticker;
  Commands* m_commands;
  SceneFiles* m_files;
  Exports* m_exports;

  MainMenu* m_menu;
  SceneArea* m_view;
  PresentationHeader* m_header;
  QWidget* m_timeline;
  QWidget* m_tools;
  SceneCommands* m_hand = nullptr;
  TargetControl* m_target;
  PlaybackBar* m_playback;
  ChartsPanel* m_charts;
  LessonGuide* m_lessons;
  Presentation* m_presentation;
  MessageBar* m_recoveryBar;
  MessageBar* m_problemBar;
  MessageBar* m_stopBar;
  QLabel* m_painterLabel;
  DraftKeeper* m_drafts = nullptr;   // none: nothing is kept
  TradeWindow* m_trade = nullptr;    // made when it is wanted first
  CutWindow* m_whenToCut = nullptr;  // likewise
  bool m_panelsSized = false;        // once: from then on the user decides
};

}  // namespace ui
