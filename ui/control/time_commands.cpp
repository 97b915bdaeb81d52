#include "ui/control/time_commands.h"

#include <QAction>
#include <QInputDialog>

#include "ui/control/commands.h"
#include "ui/control/event_navigator.h"
#include "ui/control/run_controller.h"

namespace ui {
namespace {

constexpr double kLatest = 1e6;  // s
constexpr int kDecimals = 4;

}  // namespace

TimeCommands::TimeCommands(const Commands& commands, RunController* controller,
                           EventNavigator* events, QWidget* window)
    : QObject(window), m_commands(commands), m_controller(controller), m_window(window) {
  connectSteps();
  connectEvents(events);
  connectPlaces();
  connect(controller, &RunController::timeShown, this, &TimeCommands::offerWhatCanBeDone);
  connect(controller, &RunController::busyChanged, this, &TimeCommands::offerWhatCanBeDone);
  connect(controller, &RunController::framePassed, this, &TimeCommands::offerWhatCanBeDone);
  connect(controller, &RunController::runStatusChanged, this, &TimeCommands::offerWhatCanBeDone);
}

void TimeCommands::connectSteps() {
  const auto on = [this](Command command, auto slot) {
    connect(m_commands.action(command), &QAction::triggered, m_controller, slot);
  };
  on(Command::kStep, &RunController::stepOnce);
  on(Command::kStepBack, &RunController::stepBack);
  on(Command::kStepFrame, &RunController::stepFrame);
  on(Command::kStepFrameBack, &RunController::stepFrameBack);
}

void TimeCommands::connectEvents(EventNavigator* events) {
  const auto on = [this, events](Command next, Command previous, EventGroup group) {
    connect(m_commands.action(next), &QAction::triggered, events,
            [events, group] { events->goToNext(group); });
    connect(m_commands.action(previous), &QAction::triggered, events,
            [events, group] { events->goToPrevious(group); });
  };
  on(Command::kNextEvent, Command::kPreviousEvent, EventGroup::kAll);
  on(Command::kNextImpact, Command::kPreviousImpact, EventGroup::kImpacts);
  on(Command::kNextTurningPoint, Command::kPreviousTurningPoint, EventGroup::kTurningPoints);
  on(Command::kNextCut, Command::kPreviousCut, EventGroup::kCuts);
}

void TimeCommands::connectPlaces() {
  const auto on = [this](Command command, auto slot) {
    connect(m_commands.action(command), &QAction::triggered, this, slot);
  };
  on(Command::kGoToStart, [this] { m_controller->showTime(0); });
  on(Command::kGoToEnd, [this] { m_controller->showTime(m_controller->recordedUntil()); });
  on(Command::kGoTo, &TimeCommands::askAndGo);
  on(Command::kStopTravelling, [this] { m_controller->stopWork(); });
}

void TimeCommands::offerWhatCanBeDone() {
  const auto offer = [this](std::initializer_list<Command> commands, bool isOffered) {
    for (const Command command : commands) m_commands.action(command)->setEnabled(isOffered);
  };
  const double time = m_controller->time();
  offer({Command::kStepBack, Command::kStepFrameBack, Command::kPreviousEvent,
         Command::kPreviousImpact, Command::kPreviousTurningPoint, Command::kPreviousCut,
         Command::kGoToStart},
        time > 0);
  offer({Command::kPlay, Command::kStep, Command::kStepFrame, Command::kNextEvent,
         Command::kNextImpact, Command::kNextTurningPoint, Command::kNextCut},
        m_controller->canGoOn());
  offer({Command::kGoToEnd}, time < m_controller->recordedUntil());
  offer({Command::kStopTravelling}, m_controller->isTravelling() || m_controller->waited() > 0);
}

void TimeCommands::askAndGo() {
  m_controller->pause();
  bool isChosen = false;
  const double time =
      QInputDialog::getDouble(m_window, tr("Go to a time"), tr("Simulated time in s"),
                              m_controller->time(), 0, kLatest, kDecimals, &isChosen);
  if (isChosen) m_controller->goTo(time);
}

}  // namespace ui
