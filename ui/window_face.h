#pragma once

#include <memory>

#include <QWidget>

class QLabel;
class QMainWindow;

namespace ui {

class ChartsPanel;
class Commands;
class CutWindow;
class Exports;
class HelpDesk;
class LessonGuide;
class MainMenu;
class MessageBar;
class PlaybackBar;
class Presentation;
class PresentationHeader;
class SceneArea;
class SceneCommands;
class TargetControl;
class TradeWindow;
class WindowPanels;
class Workbench;
struct FaceView;

/// All that a window shows, in one language: the scene in the middle, forms at its side, charts
/// below, menus and status bar. Puts the parts together and passes on what they say; each part
/// does its own work.
///
/// Is the window's central widget. Nothing that must outlive a change of the language is kept
/// here: that belongs to the workbench.
class WindowFace : public QWidget {
  Q_OBJECT

 public:
  /// @param area  shows the scene; becomes part of the face
  WindowFace(QMainWindow* window, Workbench* bench, SceneArea* area);
  ~WindowFace() override;

  Exports* exports() const { return m_exports; }
  const Commands& commands() const { return *m_commands; }
  ChartsPanel* charts() const;
  LessonGuide* lessons() const { return m_lessons; }
  Presentation* presentation() const { return m_presentation; }
  TargetControl* target() const { return m_target; }
  const WindowPanels& panels() const { return *m_panels; }

  /// Says what can be brought back after a crash, and what cannot be kept for one.
  void offerRecovery();

  /// How it is laid out and what is switched on, for another one to go on with.
  FaceView view() const;
  void setView(const FaceView& view);

  /// Shows words in the status bar for a while.
  void say(const QString& words);

 signals:
  /// The user wants another language: one of Language.
  void languageChosen(int language);

 private:
  void build();
  void buildMenus();
  void addChoices();
  void buildStatusBar();
  void connectPlayback();
  void connectScene();
  void connectFiles();
  void connectMessages();
  void connectView();
  void preparePresentation();
  void connectTarget();

  void listRuns();
  void showTime(double time);
  void showStopped();
  void showProblems();
  void showTitle();
  void showPainter();
  void changeSpeed(int steps);
  void showTrade();
  void showWhenToCut();

  QMainWindow* m_window;
  Workbench* m_bench;
  SceneArea* m_area;
  Commands* m_commands;
  Exports* m_exports;
  MainMenu* m_menu = nullptr;
  PresentationHeader* m_header;
  QWidget* m_timeline;
  QWidget* m_tools;
  SceneCommands* m_hand = nullptr;
  TargetControl* m_target = nullptr;
  HelpDesk* m_help = nullptr;
  PlaybackBar* m_playback;
  std::unique_ptr<WindowPanels> m_panels;
  LessonGuide* m_lessons = nullptr;
  Presentation* m_presentation = nullptr;
  MessageBar* m_recoveryBar;
  MessageBar* m_problemBar;
  MessageBar* m_stopBar;
  QLabel* m_painterLabel = nullptr;
  TradeWindow* m_trade = nullptr;    // made when it is wanted first
  CutWindow* m_whenToCut = nullptr;  // likewise
};

}  // namespace ui
