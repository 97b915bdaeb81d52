#pragma once

class QString;

class QMainWindow;

namespace ui {

class ChartsPanel;
class Commands;
class RunController;

/// Brings back how the user left the window last time: its size, the speed, switches and the
/// kind of chart. (Panels come back when they are laid out.)
class WindowMemory {
 public:
  WindowMemory(QMainWindow* window, const Commands& commands, RunController* controller,
               ChartsPanel* charts)
      : m_window(window), m_commands(commands), m_controller(controller), m_charts(charts) {}

  void restore() const;
  void save() const;

 private:
  void chooseChart(const QString& id) const;

  QMainWindow* m_window;
  const Commands& m_commands;
  RunController* m_controller;
  ChartsPanel* m_charts;
};

}  // namespace ui
