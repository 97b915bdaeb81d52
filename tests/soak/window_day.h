#pragma once

#include <memory>

#include <QString>

#include "tests/soak/process_figures.h"

class QTemporaryDir;

namespace ui {
class MainWindow;
}

/// What a window takes.
struct WindowFigures {
  ProcessFigures process;
  int objects = 0;  ///< of Qt, below the window
  int windows = 0;  ///< of the program, hidden ones too
};

/// A window through a school day: hour after hour all lessons are opened and played, cut,
/// changed, looked at in every chart, presented, exported, kept and undone.
class WindowDay {
 public:
  /// @param lessons  how many are opened each hour, at most all
  explicit WindowDay(int lessons);
  ~WindowDay();

  /// @param seconds  of simulated time that are played
  void spendHour(double seconds);
  /// Once everything that goes later is gone.
  WindowFigures figures() const;

 private:
  void playLesson(const QString& name, double seconds);
  void lookAround();
  void writeFiles();
  void changeAndUndo();
  void showWhenToCut();
  void waitUntilStill() const;
  int objectCount() const;

  int m_lessons;
  std::unique_ptr<QTemporaryDir> m_folder;
  std::unique_ptr<ui::MainWindow> m_window;
};
