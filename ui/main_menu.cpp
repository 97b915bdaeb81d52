#include "ui/main_menu.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QToolButton>

#include "ui/control/commands.h"
#include "ui/files/lessons.h"
#include "ui/style/icons.h"

namespace ui {
namespace {

void addCommands(QMenu* menu, const Commands& commands, std::initializer_list<Command> list) {
  for (const Command command : list) menu->addAction(commands.action(command));
}

}  // namespace

MainMenu::MainMenu(QMenuBar* bar, const Commands& commands) : QObject(bar) {
  addFileMenu(bar, commands);
  addEditMenu(bar, commands);
  addRunMenu(bar, commands);
  addViewMenu(bar, commands);
  addWeightMenu(bar, commands);
  addChartMenu(bar, commands);
  addHelpMenu(bar, commands);
  addButtons(bar, commands);
}

/// At the right end of the menu bar: what begins a lesson, and what shows it large.
void MainMenu::addButtons(QMenuBar* bar, const Commands& commands) {
  auto* corner = new QWidget;
  auto* layout = new QHBoxLayout(corner);
  layout->setContentsMargins(0, 0, 8, 0);
  layout->setSpacing(4);
  for (const Command command : {Command::kLessons, Command::kPresent}) {
    auto* button = new QToolButton;
    button->setDefaultAction(commands.action(command));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    layout->addWidget(button);
  }
  bar->setCornerWidget(corner);
}

void MainMenu::addFileMenu(QMenuBar* bar, const Commands& commands) {
  QMenu* file = bar->addMenu(tr("&File"));
  addCommands(file, commands, {Command::kNew, Command::kOpen, Command::kLessons});
  m_recent = file->addMenu(tr("Open &recent"));
  m_scenes = file->addMenu(tr("&Built-in scenes"));
  m_scenes->setToolTipsVisible(true);
  connect(m_scenes, &QMenu::aboutToShow, this, &MainMenu::listBuiltInScenes);
  file->addSeparator();
  addCommands(file, commands, {Command::kSave, Command::kSaveAs});
  file->addSeparator();
  addCommands(file, commands, {Command::kExportChart, Command::kExportPicture});
  m_ledgers = file->addMenu(icon("table"), tr("Export energy &ledger"));
  file->addSeparator();
  addCommands(file, commands, {Command::kQuit});
}

void MainMenu::addEditMenu(QMenuBar* bar, const Commands& commands) {
  QMenu* edit = bar->addMenu(tr("&Edit"));
  addCommands(edit, commands, {Command::kUndo, Command::kRedo});
  edit->addSeparator();
  addCommands(edit, commands, {Command::kWeightsTable});
}

void MainMenu::addRunMenu(QMenuBar* bar, const Commands& commands) {
  QMenu* run = bar->addMenu(tr("&Run"));
  addCommands(run, commands,
              {Command::kPlay, Command::kStep, Command::kStepBack, Command::kStepFrame,
               Command::kStepFrameBack});
  addGoToMenu(run->addMenu(tr("&Go to")), commands);
  run->addSeparator();
  addCommands(run, commands, {Command::kCut, Command::kReset});
  run->addSeparator();
  addCommands(run, commands, {Command::kSlower, Command::kFaster});
  run->addSeparator();
  addCommands(run, commands, {Command::kWhenToCut, Command::kMeasure});
}

void MainMenu::addGoToMenu(QMenu* menu, const Commands& commands) {
  addCommands(menu, commands, {Command::kNextEvent, Command::kPreviousEvent});
  menu->addSeparator();
  addCommands(menu, commands,
              {Command::kNextImpact, Command::kPreviousImpact, Command::kNextTurningPoint,
               Command::kPreviousTurningPoint, Command::kNextCut, Command::kPreviousCut});
  menu->addSeparator();
  addCommands(menu, commands,
              {Command::kGoToStart, Command::kGoToEnd, Command::kGoTo, Command::kStopTravelling});
}

void MainMenu::addViewMenu(QMenuBar* bar, const Commands& commands) {
  m_view = bar->addMenu(tr("&View"));
  m_panels = m_view->addMenu(tr("&Panels"));
  m_view->addSeparator();
  addCommands(m_view, commands,
              {Command::kSplit, Command::kTrails, Command::kVelocities, Command::kForces,
               Command::kTensions, Command::kTarget});
  addCommands(m_view->addMenu(tr("&Measure")), commands,
              {Command::kTape, Command::kProtractor, Command::kNextToolPart, Command::kStopwatch,
               Command::kStartStopwatch, Command::kZeroStopwatch});
  m_view->addSeparator();
  addCommands(m_view, commands,
              {Command::kFit, Command::kZoomIn, Command::kZoomOut, Command::kLessonText,
               Command::kPresent});
  m_view->addSeparator();
}

void MainMenu::addWeightMenu(QMenuBar* bar, const Commands& commands) {
  QMenu* weight = bar->addMenu(tr("&Weight"));
  addCommands(weight, commands,
              {Command::kNextWeight, Command::kPreviousWeight, Command::kDeselect});
  weight->addSeparator();
  addCommands(weight, commands,
              {Command::kMoveLeft, Command::kMoveRight, Command::kMoveUp, Command::kMoveDown});
  weight->addSeparator();
  addCommands(weight, commands,
              {Command::kAccelerateLeft, Command::kAccelerateRight, Command::kAccelerateUp,
               Command::kAccelerateDown});
}

void MainMenu::addChartMenu(QMenuBar* bar, const Commands& commands) {
  QMenu* chart = bar->addMenu(tr("&Chart"));
  addCommands(chart, commands, {Command::kNextChart, Command::kPreviousChart});
  chart->addSeparator();
  addCommands(chart, commands,
              {Command::kChartReset, Command::kCopyChart, Command::kCopyChartData});
}

void MainMenu::addHelpMenu(QMenuBar* bar, const Commands& commands) {
  QMenu* help = bar->addMenu(tr("&Help"));
  addCommands(help, commands,
              {Command::kGuide, Command::kTour, Command::kKeys, Command::kModel, Command::kSheet});
  help->addSeparator();
  addCommands(help, commands, {Command::kAbout});
}

void MainMenu::addChoice(const QString& title, const QStringList& words, int chosen,
                         const std::function<void(int)>& choose) {
  QMenu* menu = m_view->addMenu(title);
  auto* group = new QActionGroup(menu);
  for (int i = 0; i < words.size(); ++i) {
    QAction* action = group->addAction(words[i]);
    action->setCheckable(true);
    action->setChecked(i == chosen);
    connect(action, &QAction::triggered, this, [choose, i] { choose(i); });
  }
  menu->addActions(group->actions());
}

void MainMenu::setRuns(const QStringList& names) {
  m_ledgers->clear();
  for (int i = 0; i < names.size(); ++i) {
    connect(m_ledgers->addAction(names[i]), &QAction::triggered, this,
            [this, i] { emit ledgerChosen(i); });
  }
}

void MainMenu::listBuiltInScenes() {
  if (!m_scenes->isEmpty()) return;
  for (const Lesson& lesson : lessons()) {
    QAction* action = m_scenes->addAction(lesson.title);
    action->setToolTip(lesson.look);
    action->setStatusTip(action->toolTip());
    connect(action, &QAction::triggered, this,
            [this, name = lesson.name] { emit builtInChosen(name); });
  }
}

}  // namespace ui
