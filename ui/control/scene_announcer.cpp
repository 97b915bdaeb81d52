#include "ui/control/scene_announcer.h"

#include <algorithm>
#include <utility>

#include <QLocale>

#include "core/recording/event_log.h"
#include "ui/control/event_navigator.h"
#include "ui/control/event_words.h"
#include "ui/control/run_controller.h"
#include "ui/control/selection.h"

namespace ui {

SceneAnnouncer::SceneAnnouncer(const RunController* controller, const EventNavigator* events,
                               const Selection* selection, QObject* parent)
    : QObject(parent), m_controller(controller), m_events(events) {
  m_pause.setSingleShot(true);
  m_pause.setInterval(kPause);
  connect(&m_pause, &QTimer::timeout, this, &SceneAnnouncer::speakSoon);
  connect(controller, &RunController::restarted, this, &SceneAnnouncer::beginAnew);
  connect(events, &EventNavigator::runChanged, this, &SceneAnnouncer::beginAnew);
  connect(controller, &RunController::timeShown, this, &SceneAnnouncer::followTime);
  connect(selection, &Selection::weightSelected, this, &SceneAnnouncer::followSelection);
}

void SceneAnnouncer::beginAnew() {
  m_counts.clear();
  m_heardUntil = m_controller->time();
  // What happens at the very start belongs to what comes.
  m_heardCount = m_heardUntil > 0 ? countUntil(m_heardUntil) : 0;
}

std::size_t SceneAnnouncer::countUntil(double time) const {
  const auto events = m_events->log().events();
  const auto later = std::ranges::upper_bound(events, time, {}, &core::Event::time);
  return m_events->log().forgotten() + static_cast<std::size_t>(later - events.begin());
}

/// Counted, since a cut happens at a moment that is shown already. Going back is silent: what was
/// heard may be heard again.
void SceneAnnouncer::followTime(double time) {
  const std::size_t until = countUntil(time);
  const std::size_t forgotten = m_events->log().forgotten();
  if (time >= m_heardUntil) {
    for (std::size_t i = std::max(m_heardCount, forgotten); i < until; ++i) {
      m_latest = m_events->log().events()[i - forgotten];
      ++m_counts[m_latest.kind];
    }
  }
  m_heardUntil = time;
  m_heardCount = until;
  if (!m_counts.empty()) speakSoon();
}

void SceneAnnouncer::followSelection(int weight) {
  m_selected = weight < 0 ? tr("No weight selected") : tr("Weight %1 selected").arg(weight + 1);
  speakSoon();
}

void SceneAnnouncer::speakSoon() {
  if (m_pause.isActive() || (m_selected.isEmpty() && m_counts.empty())) return;
  speak();
  m_pause.start();
}

void SceneAnnouncer::speak() {
  QStringList words;
  if (!m_selected.isEmpty()) words << std::exchange(m_selected, {});
  if (!m_counts.empty()) words << eventsInWords();
  m_counts.clear();
  emit said(words.join(QStringLiteral(". ")));
}

/// One event by its weights and its time, several by how many there are of each kind.
QString SceneAnnouncer::eventsInWords() const {
  const bool isOne = m_counts.size() == 1 && m_counts.begin()->second == 1;
  if (isOne) {
    return tr("%1: weight %2, at %3 s", "an event, such as: Impact on the floor")
        .arg(eventWords(m_latest.kind), whoWords(m_latest),
             QLocale().toString(m_latest.time, 'f', 3));
  }
  QStringList words;
  for (const auto& [kind, count] : m_counts)
    words << tr("%1: %2", "an event and how many there are")
                 .arg(eventWords(kind), QLocale().toString(count));
  return words.join(QStringLiteral(", "));
}

}  // namespace ui
