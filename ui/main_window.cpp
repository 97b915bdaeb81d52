#include "ui/main_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QScreen>
#include <QShowEvent>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

#include "ui/control/commands.h"
#include "ui/control/draft_keeper.h"
#include "ui/control/event_navigator.h"
#include "ui/control/exports.h"
#include "ui/control/frame_ticker.h"
#include "ui/control/lesson_guide.h"
#include "ui/control/presentation.h"
#include "ui/control/problem_words.h"
#include "ui/control/recent_files.h"
#include "ui/control/recovery.h"
#include "ui/control/run_controller.h"
#include "ui/control/run_words.h"
#include "ui/control/scene_commands.h"
#include "ui/control/scene_drop.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/control/scene_target.h"
#include "ui/control/selection.h"
#include "ui/control/settings.h"
#include "ui/control/target_control.h"
#include "ui/control/time_commands.h"
#include "ui/control/undo_commands.h"
#include "ui/help/help_desk.h"
#include "ui/main_menu.h"
#include "ui/panels/charts_panel.h"
#include "ui/panels/comparison_panel.h"
#include "ui/panels/cut_window.h"
#include "ui/panels/events_panel.h"
#include "ui/panels/form_area.h"
#include "ui/panels/help_dialogs.h"
#include "ui/panels/lesson_panel.h"
#include "ui/panels/message_bar.h"
#include "ui/panels/panel_title.h"
#include "ui/panels/playback_bar.h"
#include "ui/panels/presentation_header.h"
#include "ui/panels/runs_form.h"
#include "ui/panels/scene_form.h"
#include "ui/panels/scene_toolbar.h"
#include "ui/panels/selection_links.h"
#include "ui/panels/step_panel.h"
#include "ui/panels/timeline.h"
#include "ui/panels/trade_window.h"
#include "ui/panels/travel_bar.h"
#include "ui/panels/weights_form.h"
#include "ui/panels/weights_table.h"
#include "ui/style/appearance.h"
#include "ui/style/icons.h"
#include "ui/view/scene_area.h"
#include "ui/window_memory.h"

namespace ui {
namespace {

constexpr QSize kFirstSize(1600, 900);
constexpr QSize kFrame(8, 48);
constexpr double kChartShare = 0.4;  // of the height that scene and chart have together
constexpr int kMessageTime = 6000;   // ms

}  // namespace

MainWindow::MainWindow(const core::Scene& scene, const QString& file, QWidget* parent)
    : QMainWindow(parent),
      m_appearance(new Appearance(this)),
      m_editor(new SceneEditor(scene, this)),
      m_selection(new Selection(m_editor, this)),
      m_controller(new RunController(this)),
      m_events(new EventNavigator(m_controller, this)),
      m_ticker(new FrameTicker(this)),
      m_commands(new Commands(this)),
      m_files(new SceneFiles(m_editor, file, this)),
      m_view(new SceneArea),
      m_playback(new PlaybackBar(*m_commands)),
      m_charts(new ChartsPanel(m_controller, *m_commands)) {
  m_exports = new Exports(
      m_controller, [this] { return m_charts->picture(); }, this);
  m_appearance->setChoice(Settings().theme());
  m_appearance->setTextSize(Settings().textSize());
  setWindowIcon(icon("angrycuts"));
  const QSize available = screen()->availableSize();
  resize(kFirstSize.boundedTo(available));
  // The desktop's frame needs room, too.
  const QSize framed = kFirstSize + kFrame;
  if (framed.boundedTo(available) != framed) setWindowState(Qt::WindowMaximized);
  buildCentre();
  buildPanels();
  buildMenus();
  buildStatusBar();
  connectPlayback();
  connectScene();
  connectFiles();
  connectView();
  preparePresentation();
  connectTarget();
  startScene();
  showTitle();
  memory().restore();
}

MainWindow::~MainWindow() = default;

WindowMemory MainWindow::memory() {
  return {this, *m_commands, m_controller, m_charts};
}

void MainWindow::keepDraftsIn(const QString& folder) {
  m_drafts = new DraftKeeper(m_editor, folder, DraftKeeper::kUsualDelay, this);
  auto* recovery = new Recovery(m_editor, m_files, m_drafts, folder, this);
  connect(m_drafts, &DraftKeeper::failed, this, [this](const QString& reason) {
    statusBar()->showMessage(tr("Unsaved changes cannot be kept for a crash: %1").arg(reason));
  });
  connect(recovery, &Recovery::offered, m_recoveryBar, &MessageBar::say);
  connect(m_recoveryBar, &MessageBar::accepted, recovery, &Recovery::bringBack);
  connect(m_recoveryBar, &MessageBar::otherAccepted, recovery, &Recovery::discard);
  recovery->start();
}

void MainWindow::buildCentre() {
  m_recoveryBar = new MessageBar(tr("Bring them back"), tr("Discard"));
  m_problemBar = new MessageBar(tr("Undo the change"));
  m_stopBar = new MessageBar;
  auto* centre = new QWidget;
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_recoveryBar);
  layout->addWidget(m_problemBar);
  layout->addWidget(m_stopBar);
  m_header = new PresentationHeader;
  m_timeline = new Timeline(m_controller, m_events);
  m_tools = sceneToolbar(*m_commands);
  layout->addWidget(m_header);
  auto* bench = new QHBoxLayout;
  bench->addWidget(m_tools);
  bench->addWidget(m_view, 1);
  layout->addLayout(bench, 1);
  layout->addWidget(m_timeline);
  layout->addWidget(m_playback);
  setCentralWidget(centre);
}

void MainWindow::buildPanels() {
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setTabPosition(Qt::LeftDockWidgetArea, QTabWidget::North);
  auto* lessonPanel = new LessonPanel(*m_commands);
  QDockWidget* lesson =
      addPanel(Qt::LeftDockWidgetArea, "lesson", tr("Lesson"), new FormArea(lessonPanel));
  m_lessons = new LessonGuide(*m_commands, m_editor, m_files, lessonPanel, lesson, this);
  QDockWidget* scene =
      addPanel(Qt::LeftDockWidgetArea, "scene", tr("Scene"), new FormArea(new SceneForm(m_editor)));
  auto* weightsForm = new WeightsForm(m_editor);
  QDockWidget* weights =
      addPanel(Qt::LeftDockWidgetArea, "weights", tr("Weights"), new FormArea(weightsForm));
  // The methods are what the program is about.
  auto* runsArea = new FormArea(new RunsForm(m_editor), FormArea::Height::kWhole);
  QDockWidget* runs = addPanel(Qt::LeftDockWidgetArea, "runs", tr("Runs"), runsArea);
  QDockWidget* charts = addPanel(Qt::BottomDockWidgetArea, "charts", tr("Charts"), m_charts);
  auto* comparison = new ComparisonPanel(m_controller);
  QDockWidget* compared =
      addPanel(Qt::BottomDockWidgetArea, "comparison", tr("Comparison"), comparison);
  compared->setTitleBarWidget(new PanelTitle(compared, comparison->chooser()));
  tabifyDockWidget(charts, compared);
  auto* step = new StepPanel(m_controller);
  QDockWidget* opened = addPanel(Qt::BottomDockWidgetArea, "step", tr("Inside a step"), step);
  opened->setTitleBarWidget(new PanelTitle(opened, step->choosers()));
  tabifyDockWidget(compared, opened);
  connect(opened, &QDockWidget::visibilityChanged, step, &StepPanel::setSeen);
  connect(step, &StepPanel::stepOpened, m_view, &SceneArea::showStep);
  auto* eventsPanel = new EventsPanel(m_controller, m_events);
  QDockWidget* events = addPanel(Qt::BottomDockWidgetArea, "events", tr("Events"), eventsPanel);
  linkSelection(m_selection, m_editor, {weightsForm, step, m_charts, eventsPanel});
  auto* table = new WeightsTable(m_editor, m_selection);
  QDockWidget* tableDock =
      addPanel(Qt::BottomDockWidgetArea, "weightsTable", tr("Weights table"), table);
  tabifyDockWidget(opened, tableDock);
  tabifyDockWidget(lesson, scene);
  tabifyDockWidget(scene, weights);
  tabifyDockWidget(charts, events);
  // Their tabs are their titles.
  for (QDockWidget* dock : {lesson, scene, weights}) dock->setTitleBarWidget(new QWidget(dock));
  runs->setTitleBarWidget(new PanelTitle(runs, nullptr));
  charts->setTitleBarWidget(new PanelTitle(charts, m_charts->choosers()));
  tableDock->setTitleBarWidget(new PanelTitle(tableDock, table->buttons()));
  const QAction* showTable = m_commands->action(Command::kWeightsTable);
  connect(showTable, &QAction::triggered, this, [tableDock, table] {
    tableDock->show();
    tableDock->raise();
    table->takeKeyboard();
  });
  connect(weightsForm, &WeightsForm::tableWanted, showTable, &QAction::trigger);
  events->setTitleBarWidget(new PanelTitle(events, eventsPanel->filters()));
  scene->raise();
  charts->raise();
}

/// As the user left them, else so that scene and chart share their height.
void MainWindow::sizePanels() {
  if (restoreState(Settings().panels())) return;
  auto* charts = findChild<QDockWidget*>("charts");
  const int shared = m_view->height() + charts->height();
  resizeDocks({charts}, {static_cast<int>(shared * kChartShare)}, Qt::Vertical);
  auto* runs = findChild<QDockWidget*>("runs");
  resizeDocks({runs}, {runs->sizeHint().height()}, Qt::Vertical);
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (event->spontaneous() || m_panelsSized) return;
  m_panelsSized = true;
  sizePanels();
  m_lessons->begin();
}

QDockWidget* MainWindow::addPanel(Qt::DockWidgetArea area, const QString& name,
                                  const QString& title, QWidget* content) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(content);
  addDockWidget(area, dock);
  // Qt leaves panels that stand behind another tab visible, out of sight: hidden they need not
  // compute what they show, which saves a few ms in every frame of 10,000 weights.
  QSizePolicy policy = content->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  content->setSizePolicy(policy);
  connect(dock, &QDockWidget::visibilityChanged, content, &QWidget::setVisible);
  return dock;
}

void MainWindow::buildMenus() {
  m_menu = new MainMenu(menuBar(), *m_commands);
  for (const QDockWidget* dock : findChildren<QDockWidget*>()) {
    m_menu->panels()->addAction(dock->toggleViewAction());
  }
  m_menu->addChoice(tr("&Colors"), {tr("Like the &desktop"), tr("&Light"), tr("D&ark")},
                    static_cast<int>(Settings().theme()), [this](int choice) {
                      Settings().setTheme(static_cast<ThemeChoice>(choice));
                      m_appearance->setChoice(static_cast<ThemeChoice>(choice));
                    });
  m_menu->addChoice(tr("Te&xt size"), {tr("&Normal"), tr("&Large"), tr("&Very large")},
                    static_cast<int>(Settings().textSize()), [this](int choice) {
                      Settings().setTextSize(static_cast<TextSize>(choice));
                      m_appearance->setTextSize(static_cast<TextSize>(choice));
                    });
  m_menu->addChoice(tr("&Drawn by"), {tr("&Automatic choice"), tr("&OpenGL"), tr("&QPainter")},
                    static_cast<int>(Settings().painter()), [this](int choice) {
                      Settings().setPainter(static_cast<PainterChoice>(choice));
                      m_view->setPainterChoice(static_cast<PainterChoice>(choice));
                    });
  for (QAction* action : m_commands->all()) addAction(action);
}

void MainWindow::buildStatusBar() {
  m_painterLabel = new QLabel;
  m_painterLabel->setObjectName("painter");
  m_painterLabel->setContentsMargins(0, 0, 8, 0);
  statusBar()->addPermanentWidget(new TravelBar(m_controller));
  statusBar()->addPermanentWidget(m_painterLabel);
}

void MainWindow::connectPlayback() {
  const auto on = [this](Command command, auto slot) {
    connect(m_commands->action(command), &QAction::triggered, m_controller, slot);
  };
  on(Command::kPlay, &RunController::togglePlaying);
  on(Command::kCut, &RunController::cutAll);
  on(Command::kReset, &RunController::reset);
  new TimeCommands(*m_commands, m_controller, m_events, this);
  connect(m_commands->action(Command::kSlower), &QAction::triggered, this,
          [this] { changeSpeed(-1); });
  connect(m_commands->action(Command::kFaster), &QAction::triggered, this,
          [this] { changeSpeed(1); });
  connect(m_playback, &PlaybackBar::speedChosen, m_controller, &RunController::setSpeed);

  connect(m_ticker, &FrameTicker::ticked, m_controller, &RunController::passTime);
  connect(m_controller, &RunController::busyChanged, m_ticker, &FrameTicker::setRunning);
  connect(m_controller, &RunController::playingChanged, m_commands, &Commands::showPlaying);
  connect(m_controller, &RunController::speedChanged, m_playback, &PlaybackBar::showSpeed);
  connect(m_controller, &RunController::timeShown, this, &MainWindow::showTime);
  connect(m_controller, &RunController::framePassed, this,
          [this] { m_playback->showKeptShare(m_controller->keptShare()); });
  connect(m_controller, &RunController::runStatusChanged, this, &MainWindow::showStopped);
  connect(m_controller, &RunController::canCutChanged, m_commands->action(Command::kCut),
          &QAction::setEnabled);
  m_commands->action(Command::kCut)->setEnabled(m_controller->canCut());
}

void MainWindow::connectScene() {
  // Before anything draws the new runs: the old ones are gone.
  connect(m_controller, &RunController::restarted, this,
          [this] { m_view->setRuns(m_controller->runs()); });
  connect(m_controller, &RunController::restarted, this, [this] {
    m_commands->action(Command::kSplit)->setEnabled(m_controller->runCount() > 1);
  });
  connect(m_controller, &RunController::restarted, this, &MainWindow::showStopped);
  connect(m_editor, &SceneEditor::sceneReplaced, m_controller, &RunController::pause);
  connect(m_editor, &SceneEditor::sceneChanged, this, &MainWindow::startScene);
  connect(m_editor, &SceneEditor::draftChanged, this, &MainWindow::showProblems);
  connect(m_problemBar, &MessageBar::accepted, m_editor, &SceneEditor::giveUpDraft);
}

void MainWindow::connectFiles() {
  const auto on = [this](Command command, auto* receiver, auto slot) {
    connect(m_commands->action(command), &QAction::triggered, receiver, slot);
  };
  on(Command::kNew, m_files, &SceneFiles::startNew);
  on(Command::kOpen, m_files, &SceneFiles::askAndOpen);
  on(Command::kSave, m_files, &SceneFiles::save);
  on(Command::kSaveAs, m_files, &SceneFiles::saveAs);
  on(Command::kExportChart, m_exports, &Exports::askAndSaveChart);
  on(Command::kExportPicture, m_exports, &Exports::askAndSavePicture);
  on(Command::kQuit, this, &QWidget::close);
  on(Command::kMeasure, this, &MainWindow::showTrade);
  on(Command::kKeys, this, [this] { showKeys(*m_commands, this); });
  on(Command::kAbout, this, [this] { showAbout(this); });
  new HelpDesk(*m_commands, m_editor, this);
  new RecentFiles(m_files, m_menu->recentFiles());
  new SceneDrop(m_files, this);
  connect(m_menu, &MainMenu::builtInChosen, m_files, &SceneFiles::openBuiltIn);
  connect(m_menu, &MainMenu::ledgerChosen, m_exports, &Exports::askAndSaveLedger);

  const auto say = [this](const QString& words) { statusBar()->showMessage(words, kMessageTime); };
  connect(m_files, &SceneFiles::done, this, say);
  connect(new UndoCommands(*m_commands, m_editor, this), &UndoCommands::done, this, say);
  connect(m_events, &EventNavigator::nothingFound, this, say);
  connect(findChild<EventsPanel*>(), &EventsPanel::done, this, say);
  connect(findChild<WeightsTable*>(), &WeightsTable::done, this, say);
  connect(m_exports, &Exports::done, this, say);
  connect(m_editor, &SceneEditor::fileChanged, this, &MainWindow::showTitle);
  connect(m_editor, &SceneEditor::sceneReplaced, this, &MainWindow::showTitle);
  connect(m_editor, &SceneEditor::modifiedChanged, this, &QWidget::setWindowModified);
}

void MainWindow::connectView() {
  connect(m_commands->action(Command::kSplit), &QAction::toggled, m_view, &SceneArea::setSplit);
  connect(m_commands->action(Command::kTrails), &QAction::toggled, m_view,
          &SceneArea::setTrailsShown);
  connect(m_commands->action(Command::kFit), &QAction::triggered, m_view, &SceneArea::fitRoom);
  connect(m_commands->action(Command::kZoomIn), &QAction::triggered, m_view, &SceneArea::zoomIn);
  connect(m_commands->action(Command::kZoomOut), &QAction::triggered, m_view, &SceneArea::zoomOut);
  connect(m_view, &SceneArea::painterChanged, this, &MainWindow::showPainter);
  connect(m_view, &SceneArea::trailsChanged, this, &MainWindow::showPainter);
  m_hand = new SceneCommands(*m_commands, {m_editor, m_selection, m_controller, m_view}, this);
  m_exports->setPictured([this] {
    return PicturedMarks{m_hand->marks(), m_view->trails(), m_target->shown()};
  });
  connect(m_hand, &SceneCommands::draggingChanged, this, &MainWindow::showProblems);
  connect(m_hand, &SceneCommands::said, statusBar(),
          [this](const QString& words) { statusBar()->showMessage(words, kMessageTime); });
  m_view->setPainterChoice(Settings().painter());
  showPainter();
}

void MainWindow::preparePresentation() {
  m_presentation = new Presentation(*m_commands, {.window = this,
                                                  .appearance = m_appearance,
                                                  .controller = m_controller,
                                                  .lessons = m_lessons,
                                                  .charts = findChild<QDockWidget*>("charts"),
                                                  .header = m_header,
                                                  .scene = m_view,
                                                  .controls = {m_timeline, m_playback, m_tools}});
}

void MainWindow::connectTarget() {
  m_target = new TargetControl(*m_commands, m_controller, m_editor, m_view, this);
  // None selected: the one before stays.
  connect(m_selection, &Selection::weightSelected, m_target->target(), &SceneTarget::setWeight);
  connect(m_commands->action(Command::kWhenToCut), &QAction::triggered, this,
          &MainWindow::showWhenToCut);
}

void MainWindow::startScene() {
  m_controller->setScene(m_editor->scene());
  QStringList names;
  for (const core::Run* run : m_controller->runs()) names << runWords(run->solver());
  m_menu->setRuns(names);
}

void MainWindow::showTime(double time) {
  m_view->showTime(time);
  m_playback->showTime(time);
  m_playback->showKeptShare(m_controller->keptShare());
}

void MainWindow::showStopped() {
  QStringList stopped;
  for (const core::Run* run : m_controller->runs()) {
    if (run->status() != core::RunStatus::kRunning) stopped << stopWords(*run);
  }
  m_stopBar->say(stopped.join('\n'));
}

void MainWindow::showProblems() {
  if (m_hand->isDragging()) return;
  const auto& problems = m_editor->problems();
  m_problemBar->say(problems.empty() ? QString()
                                     : tr("Not applied: %1").arg(problemWords(problems)));
}

void MainWindow::showTitle() {
  const QString name = m_files->file().isEmpty() ? QString::fromStdString(m_editor->scene()->name)
                                                 : QFileInfo(m_files->file()).fileName();
  setWindowTitle(tr("%1[*] – Angry Cuts").arg(name.isEmpty() ? tr("New scene") : name));
}

void MainWindow::showPainter() {
  QStringList words{tr("Drawn by %1").arg(m_view->painterDescription())};
  const QString trails = m_view->trailsDescription();
  if (!trails.isEmpty()) words.prepend(trails);
  m_painterLabel->setText(words.join(QStringLiteral(" · ")));
}

void MainWindow::changeSpeed(int steps) {
  m_controller->setSpeed(m_playback->speedBeside(m_controller->speed(), steps));
}

void MainWindow::showTrade() {
  if (!m_trade) m_trade = new TradeWindow(m_editor, this);
  m_trade->bringUp();
}

void MainWindow::showWhenToCut() {
  if (!m_whenToCut) {
    m_whenToCut = new CutWindow(m_editor, m_target->target(), this);
    connect(m_whenToCut, &CutWindow::momentPicked, m_controller, &RunController::reset);
  }
  m_whenToCut->bringUp();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  event->setAccepted(m_files->mayLeaveScene());
  if (!event->isAccepted()) return;
  m_presentation->setOn(false);
  memory().save();
  if (m_drafts) m_drafts->letGo();
}

}  // namespace ui
