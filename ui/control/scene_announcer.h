#pragma once

#include <cstddef>
#include <map>

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include "core/run/event.h"

namespace ui {

class EventNavigator;
class RunController;
class Selection;

/// Puts into words what happens in the scene, for those who listen to it: which weight is
/// selected, what hits what, when ropes are cut or go slack.
///
/// Speaks of the run whose events are gone through. Says at most one thing in half a second, so
/// that a voice can follow; what happens meanwhile is summed up in the next one.
class SceneAnnouncer : public QObject {
  Q_OBJECT

 public:
  static constexpr int kPause = 500;  ///< between two announcements [ms]

  SceneAnnouncer(const RunController* controller, const EventNavigator* events,
                 const Selection* selection, QObject* parent);

 signals:
  /// Something happened, in words.
  void said(const QString& words);

 private:
  void beginAnew();
  std::size_t countUntil(double time) const;
  void followTime(double time);
  void followSelection(int weight);
  void speakSoon();
  void speak();
  QString eventsInWords() const;

  const RunController* m_controller;
  const EventNavigator* m_events;
  double m_heardUntil = 0;       // [s]
  std::size_t m_heardCount = 0;  // events up to there, forgotten ones too
  QString m_selected;            // to say; empty: nothing
  std::map<core::EventKind, int> m_counts;
  core::Event m_latest;
  QTimer m_pause;
};

}  // namespace ui
