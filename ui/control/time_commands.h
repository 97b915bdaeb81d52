#pragma once

#include <QObject>

class QWidget;

namespace ui {

class Commands;
class EventNavigator;
class RunController;

/// Lets the commands that show another moment do so, and offers those that can be used.
class TimeCommands : public QObject {
  Q_OBJECT

 public:
  /// @param window  what the question for a time stands before, and the parent
  TimeCommands(const Commands& commands, RunController* controller, EventNavigator* events,
               QWidget* window);

 private:
  void connectSteps();
  void connectEvents(EventNavigator* events);
  void connectPlaces();
  void offerWhatCanBeDone();
  void askAndGo();

  const Commands& m_commands;
  RunController* m_controller;
  QWidget* m_window;
};

}  // namespace ui
