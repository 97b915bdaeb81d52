#pragma once

#include <QObject>
#include <QString>

#include "core/recording/event_log.h"
#include "ui/control/event_words.h"

namespace ui {

class RunController;

/// Goes from event to event of one run, the first unless another is chosen.
class EventNavigator : public QObject {
  Q_OBJECT

 public:
  explicit EventNavigator(RunController* controller, QObject* parent = nullptr);

  /// Whose events these are.
  int run() const { return m_run; }
  void setRun(int run);
  const core::EventLog& log() const;

  /// Pauses and shows the next event of the group; what is not recorded yet is computed, up
  /// to a minute of simulated time.
  void goToNext(EventGroup group);
  /// Pauses and shows the event of the group before.
  void goToPrevious(EventGroup group);

 signals:
  void runChanged(int run);
  /// There is no such event, in words.
  void nothingFound(const QString& words);

 private:
  void sayNothingFound(double from, double until);

  RunController* m_controller;
  int m_run = 0;
  EventGroup m_wanted = EventGroup::kAll;
};

}  // namespace ui
