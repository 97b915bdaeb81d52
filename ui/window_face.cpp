#include "ui/window_face.h"

#include <QAction>
#include <QCoreApplication>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

#include "ui/control/commands.h"
#include "ui/control/draft_keeper.h"
#include "ui/control/event_navigator.h"
#include "ui/control/exports.h"
#include "ui/control/lesson_guide.h"
#include "ui/control/presentation.h"
#include "ui/control/problem_words.h"
#include "ui/control/recent_files.h"
#include "ui/control/recovery.h"
#include "ui/control/run_controller.h"
#include "ui/control/run_words.h"
#include "ui/control/scene_announcer.h"
#include "ui/control/scene_commands.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/control/selection.h"
#include "ui/control/settings.h"
#include "ui/control/target_control.h"
#include "ui/control/time_commands.h"
#include "ui/control/undo_commands.h"
#include "ui/face_view.h"
#include "ui/files/lessons.h"
#include "ui/help/help_desk.h"
#include "ui/main_menu.h"
#include "ui/panels/charts_panel.h"
#include "ui/panels/cut_window.h"
#include "ui/panels/events_panel.h"
#include "ui/panels/help_dialogs.h"
#include "ui/panels/message_bar.h"
#include "ui/panels/playback_bar.h"
#include "ui/panels/presentation_header.h"
#include "ui/panels/scene_toolbar.h"
#include "ui/panels/timeline.h"
#include "ui/panels/trade_window.h"
#include "ui/panels/travel_bar.h"
#include "ui/panels/weights_table.h"
#include "ui/style/appearance.h"
#include "ui/view/scene_area.h"
#include "ui/window_panels.h"
#include "ui/workbench.h"

namespace ui {
namespace {

constexpr int kMessageTime = 6000;  // ms

}  // namespace

WindowFace::WindowFace(QMainWindow* window, Workbench* bench, SceneArea* area)
    : m_window(window),
      m_bench(bench),
      m_area(area),
      m_commands(new Commands(this)),
      m_exports(new Exports(
          bench->controller(), [this] { return charts()->picture(); }, this)),
      m_header(new PresentationHeader),
      m_timeline(new Timeline(bench->controller(), bench->events())),
      m_tools(sceneToolbar(*m_commands)),
      m_playback(new PlaybackBar(*m_commands)),
      m_recoveryBar(new MessageBar(tr("Bring them back"), tr("Discard"))),
      m_problemBar(new MessageBar(tr("Undo the change"))),
      m_stopBar(new MessageBar) {
  build();
  window->setCentralWidget(this);
  m_panels = std::make_unique<WindowPanels>(window, *bench, *m_commands, m_area);
  m_lessons = new LessonGuide(*m_commands, bench->editor(), bench->files(), m_panels->lesson(),
                              m_panels->lessonDock(), this);
  buildMenus();
  buildStatusBar();
  connectPlayback();
  connectScene();
  connectFiles();
  connectMessages();
  connectView();
  preparePresentation();
  connectTarget();
  offerRecovery();
  showTitle();
  showProblems();
}

WindowFace::~WindowFace() = default;

ChartsPanel* WindowFace::charts() const {
  return m_panels->charts();
}

void WindowFace::build() {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  for (MessageBar* bar : {m_recoveryBar, m_problemBar, m_stopBar}) layout->addWidget(bar);
  layout->addWidget(m_header);
  auto* middle = new QHBoxLayout;
  middle->addWidget(m_tools);
  middle->addWidget(m_area, 1);
  layout->addLayout(middle, 1);
  layout->addWidget(m_timeline);
  layout->addWidget(m_playback);
}

void WindowFace::offerRecovery() {
  if (!m_bench->recovery()) return;
  Recovery* recovery = m_bench->recovery();
  connect(m_bench->drafts(), &DraftKeeper::failed, this, [this](const QString& reason) {
    m_window->statusBar()->showMessage(
        tr("Unsaved changes cannot be kept for a crash: %1").arg(reason));
  });
  connect(recovery, &Recovery::offered, m_recoveryBar, &MessageBar::say);
  connect(m_recoveryBar, &MessageBar::accepted, recovery, &Recovery::bringBack);
  connect(m_recoveryBar, &MessageBar::otherAccepted, recovery, &Recovery::discard);
  recovery->offerAgain();
}

void WindowFace::buildMenus() {
  m_menu = new MainMenu(m_window->menuBar(), *m_commands);
  m_panels->listIn(m_menu->panels());
  addChoices();
  for (QAction* action : m_commands->all()) m_window->addAction(action);
}

void WindowFace::addChoices() {
  m_menu->addChoice(tr("&Colors"), {tr("Like the &desktop"), tr("&Light"), tr("D&ark")},
                    static_cast<int>(Settings().theme()), [this](int choice) {
                      Settings().setTheme(static_cast<ThemeChoice>(choice));
                      m_bench->appearance()->setChoice(static_cast<ThemeChoice>(choice));
                    });
  m_menu->addChoice(tr("Te&xt size"), {tr("&Normal"), tr("&Large"), tr("&Very large")},
                    static_cast<int>(Settings().textSize()), [this](int choice) {
                      Settings().setTextSize(static_cast<TextSize>(choice));
                      m_bench->appearance()->setTextSize(static_cast<TextSize>(choice));
                    });
  m_menu->addChoice(tr("&Drawn by"), {tr("&Automatic choice"), tr("&OpenGL"), tr("&QPainter")},
                    static_cast<int>(Settings().painter()), [this](int choice) {
                      Settings().setPainter(static_cast<PainterChoice>(choice));
                      m_area->setPainterChoice(static_cast<PainterChoice>(choice));
                    });
  QStringList languages{tr("Like the &desktop")};
  for (int i = 1; i < kLanguageCount; ++i) languages << nameOf(static_cast<Language>(i));
  m_menu->addChoice(tr("Lan&guage"), languages, static_cast<int>(Settings().language()),
                    [this](int choice) { emit languageChosen(choice); });
}

void WindowFace::buildStatusBar() {
  m_painterLabel = new QLabel;
  m_painterLabel->setObjectName("painter");
  m_painterLabel->setContentsMargins(0, 0, 8, 0);
  m_window->statusBar()->addPermanentWidget(new TravelBar(m_bench->controller()));
  m_window->statusBar()->addPermanentWidget(m_painterLabel);
}

void WindowFace::connectPlayback() {
  RunController* controller = m_bench->controller();
  const auto on = [&](Command command, auto slot) {
    connect(m_commands->action(command), &QAction::triggered, controller, slot);
  };
  on(Command::kPlay, &RunController::togglePlaying);
  on(Command::kCut, &RunController::cutAll);
  on(Command::kReset, &RunController::reset);
  new TimeCommands(*m_commands, controller, m_bench->events(), this);
  connect(m_commands->action(Command::kSlower), &QAction::triggered, this,
          [this] { changeSpeed(-1); });
  connect(m_commands->action(Command::kFaster), &QAction::triggered, this,
          [this] { changeSpeed(1); });
  connect(m_playback, &PlaybackBar::speedChosen, controller, &RunController::setSpeed);

  connect(controller, &RunController::playingChanged, m_commands, &Commands::showPlaying);
  connect(controller, &RunController::speedChanged, m_playback, &PlaybackBar::showSpeed);
  connect(controller, &RunController::timeShown, this, &WindowFace::showTime);
  connect(controller, &RunController::framePassed, this,
          [this, controller] { m_playback->showKeptShare(controller->keptShare()); });
  connect(controller, &RunController::runStatusChanged, this, &WindowFace::showStopped);
  QAction* cut = m_commands->action(Command::kCut);
  connect(controller, &RunController::canCutChanged, cut, &QAction::setEnabled);
  cut->setEnabled(false);
}

void WindowFace::connectScene() {
  RunController* controller = m_bench->controller();
  connect(controller, &RunController::restarted, this, &WindowFace::listRuns);
  connect(controller, &RunController::restarted, this, &WindowFace::showStopped);
  SceneEditor* editor = m_bench->editor();
  connect(editor, &SceneEditor::draftChanged, this, &WindowFace::showProblems);
  connect(m_problemBar, &MessageBar::accepted, editor, &SceneEditor::giveUpDraft);
}

void WindowFace::connectFiles() {
  const auto on = [this](Command command, auto* receiver, auto slot) {
    connect(m_commands->action(command), &QAction::triggered, receiver, slot);
  };
  SceneFiles* files = m_bench->files();
  on(Command::kNew, files, &SceneFiles::startNew);
  on(Command::kOpen, files, &SceneFiles::askAndOpen);
  on(Command::kSave, files, &SceneFiles::save);
  on(Command::kSaveAs, files, &SceneFiles::saveAs);
  on(Command::kExportChart, m_exports, &Exports::askAndSaveChart);
  on(Command::kExportPicture, m_exports, &Exports::askAndSavePicture);
  on(Command::kQuit, m_window, &QWidget::close);
  on(Command::kMeasure, this, &WindowFace::showTrade);
  on(Command::kKeys, this, [this] { showKeys(*m_commands, this); });
  on(Command::kAbout, this, [this] { showAbout(this); });
  m_help = new HelpDesk(*m_commands, m_bench->editor(), m_window, this);
  connect(m_help, &HelpDesk::done, this, &WindowFace::say);
  new RecentFiles(files, m_menu->recentFiles());
  connect(m_menu, &MainMenu::builtInChosen, files, &SceneFiles::openBuiltIn);
  connect(m_menu, &MainMenu::ledgerChosen, m_exports, &Exports::askAndSaveLedger);
}

void WindowFace::connectMessages() {
  auto* undo = new UndoCommands(*m_commands, m_bench->editor(), this);
  connect(undo, &UndoCommands::done, this, &WindowFace::say);
  connect(m_bench->files(), &SceneFiles::done, this, &WindowFace::say);
  connect(m_bench->events(), &EventNavigator::nothingFound, this, &WindowFace::say);
  connect(m_panels->events(), &EventsPanel::done, this, &WindowFace::say);
  connect(m_panels->table(), &WeightsTable::done, this, &WindowFace::say);
  connect(m_exports, &Exports::done, this, &WindowFace::say);
  const SceneEditor* editor = m_bench->editor();
  connect(editor, &SceneEditor::fileChanged, this, &WindowFace::showTitle);
  connect(editor, &SceneEditor::sceneReplaced, this, &WindowFace::showTitle);
  connect(editor, &SceneEditor::modifiedChanged, m_window, &QWidget::setWindowModified);
}

void WindowFace::connectView() {
  const auto on = [this](Command command, auto slot) {
    connect(m_commands->action(command), &QAction::triggered, m_area, slot);
  };
  on(Command::kFit, &SceneArea::fitRoom);
  on(Command::kZoomIn, &SceneArea::zoomIn);
  on(Command::kZoomOut, &SceneArea::zoomOut);
  connect(m_commands->action(Command::kSplit), &QAction::toggled, m_area, &SceneArea::setSplit);
  connect(m_commands->action(Command::kTrails), &QAction::toggled, m_area,
          &SceneArea::setTrailsShown);
  connect(m_area, &SceneArea::painterChanged, this, &WindowFace::showPainter);
  connect(m_area, &SceneArea::trailsChanged, this, &WindowFace::showPainter);
  m_hand = new SceneCommands(*m_commands,
                             {.editor = m_bench->editor(),
                              .selection = m_bench->selection(),
                              .controller = m_bench->controller(),
                              .tools = m_bench->tools(),
                              .area = m_area},
                             this);
  m_exports->setPictured([this] {
    return PicturedMarks{m_hand->marks(), m_area->trails(), m_target->shown()};
  });
  connect(m_hand, &SceneCommands::draggingChanged, this, &WindowFace::showProblems);
  connect(m_hand, &SceneCommands::said, this, &WindowFace::say);
  auto* announcer =
      new SceneAnnouncer(m_bench->controller(), m_bench->events(), m_bench->selection(), this);
  connect(announcer, &SceneAnnouncer::said, m_area, &SceneArea::announce);
  m_area->setPainterChoice(Settings().painter());
  showPainter();
}

void WindowFace::preparePresentation() {
  m_presentation = new Presentation(*m_commands,
                                    {.window = m_window,
                                     .appearance = m_bench->appearance(),
                                     .controller = m_bench->controller(),
                                     .lessons = m_lessons,
                                     .charts = m_panels->chartsDock(),
                                     .header = m_header,
                                     .scene = m_area,
                                     .controls = {m_timeline, m_playback, m_tools}},
                                    this);
}

void WindowFace::connectTarget() {
  m_target = new TargetControl(*m_commands, m_bench->controller(), m_bench->target(), m_area, this);
  connect(m_commands->action(Command::kWhenToCut), &QAction::triggered, this,
          &WindowFace::showWhenToCut);
}

FaceView WindowFace::view() const {
  FaceView view{m_window->saveState(), {}, charts()->view(), {}, {}, m_help->place()};
  for (const auto& [command, action] : m_commands->byCommand())
    if (action->isCheckable()) view.switches[command] = action->isChecked();
  if (m_trade && m_trade->isVisible()) view.trade = m_trade->saveGeometry();
  if (m_whenToCut && m_whenToCut->isVisible()) view.whenToCut = m_whenToCut->saveGeometry();
  return view;
}

void WindowFace::setView(const FaceView& view) {
  for (const auto& [command, isOn] : view.switches) m_commands->action(command)->setChecked(isOn);
  charts()->setView(view.charts);
  m_lessons->showText();
  // Only what is laid out has the sizes that it is given.
  m_window->restoreState(view.panels);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  m_window->restoreState(view.panels);
  if (view.trade) {
    showTrade();
    m_trade->restoreGeometry(*view.trade);
  }
  if (view.whenToCut) {
    showWhenToCut();
    m_whenToCut->restoreGeometry(*view.whenToCut);
  }
  if (view.help) m_help->open(*view.help);
}

void WindowFace::say(const QString& words) {
  m_window->statusBar()->showMessage(words, kMessageTime);
}

void WindowFace::listRuns() {
  QStringList names;
  for (const core::Run* run : m_bench->controller()->runs()) names << runWords(run->solver());
  m_menu->setRuns(names);
  m_commands->action(Command::kSplit)->setEnabled(names.size() > 1);
}

void WindowFace::showTime(double time) {
  m_area->showTime(time);
  m_playback->showTime(time);
  m_playback->showKeptShare(m_bench->controller()->keptShare());
}

void WindowFace::showStopped() {
  QStringList stopped;
  for (const core::Run* run : m_bench->controller()->runs()) {
    if (run->status() != core::RunStatus::kRunning) stopped << stopWords(*run);
  }
  m_stopBar->say(stopped.join('\n'));
}

void WindowFace::showProblems() {
  if (m_hand->isDragging()) return;
  const auto& problems = m_bench->editor()->problems();
  m_problemBar->say(problems.empty() ? QString()
                                     : tr("Not applied: %1").arg(problemWords(problems)));
}

void WindowFace::showTitle() {
  const QString file = m_bench->files()->file();
  const QString name =
      file.isEmpty() ? titleOf(*m_bench->editor()->scene()) : QFileInfo(file).fileName();
  m_window->setWindowTitle(tr("%1[*] – Angry Cuts").arg(name.isEmpty() ? tr("New scene") : name));
}

void WindowFace::showPainter() {
  QStringList words{tr("Drawn by %1").arg(m_area->painterDescription())};
  const QString trails = m_area->trailsDescription();
  if (!trails.isEmpty()) words.prepend(trails);
  m_painterLabel->setText(words.join(QStringLiteral(" · ")));
}

void WindowFace::changeSpeed(int steps) {
  RunController* controller = m_bench->controller();
  controller->setSpeed(m_playback->speedBeside(controller->speed(), steps));
}

void WindowFace::showTrade() {
  if (!m_trade) m_trade = new TradeWindow(m_bench->editor(), this);
  m_trade->bringUp();
}

void WindowFace::showWhenToCut() {
  if (!m_whenToCut) {
    m_whenToCut = new CutWindow(m_bench->editor(), m_bench->target(), this);
    connect(m_whenToCut, &CutWindow::momentPicked, m_bench->controller(), &RunController::reset);
  }
  m_whenToCut->bringUp();
}

}  // namespace ui
