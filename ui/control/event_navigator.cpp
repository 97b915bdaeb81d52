#include "ui/control/event_navigator.h"

#include <QLocale>

#include "ui/control/run_controller.h"

namespace ui {
namespace {

constexpr double kLongestSearch = 60;  // s

}  // namespace

EventNavigator::EventNavigator(RunController* controller, QObject* parent)
    : QObject(parent), m_controller(controller) {
  connect(controller, &RunController::nothingFound, this, &EventNavigator::sayNothingFound);
  connect(controller, &RunController::restarted, this, [this] {
    if (m_run >= m_controller->runCount()) setRun(0);
  });
}

void EventNavigator::setRun(int run) {
  if (run == m_run) return;
  m_run = run;
  emit runChanged(run);
}

const core::EventLog& EventNavigator::log() const {
  return m_controller->recording(m_run).eventLog();
}

void EventNavigator::goToNext(EventGroup group) {
  m_wanted = group;
  const auto isWanted = [group](const core::Event& event) { return belongsTo(group, event.kind); };
  m_controller->goToNext(m_run, isWanted, m_controller->time() + kLongestSearch);
}

void EventNavigator::goToPrevious(EventGroup group) {
  m_wanted = group;
  m_controller->goToPrevious(
      m_run, [group](const core::Event& event) { return belongsTo(group, event.kind); });
}

void EventNavigator::sayNothingFound(double from, double until) {
  const auto seconds = [](double time) { return QLocale().toString(time, 'f', 3); };
  emit nothingFound(tr("%1: none between %2 s and %3 s.")
                        .arg(groupWords(m_wanted), seconds(from), seconds(until)));
}

}  // namespace ui
