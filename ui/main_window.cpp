#include "ui/main_window.h"

#include <QChildEvent>
#include <QCloseEvent>
#include <QMenuBar>
#include <QScreen>
#include <QShowEvent>
#include <QStatusBar>
#include <QTabBar>

#include "ui/control/draft_keeper.h"
#include "ui/control/lesson_guide.h"
#include "ui/control/presentation.h"
#include "ui/control/recovery.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_drop.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/control/selection.h"
#include "ui/control/settings.h"
#include "ui/face_view.h"
#include "ui/style/icons.h"
#include "ui/view/scene_area.h"
#include "ui/window_face.h"
#include "ui/window_memory.h"
#include "ui/window_panels.h"
#include "ui/workbench.h"

namespace ui {
namespace {

constexpr QSize kFirstSize(1600, 900);
constexpr QSize kFrame(8, 48);

}  // namespace

MainWindow::MainWindow(const core::Scene& scene, const QString& file, QWidget* parent)
    : QMainWindow(parent), m_bench(new Workbench(scene, file, this)), m_area(new SceneArea(this)) {
  setWindowIcon(icon("angrycuts"));
  takeUsualSize();
  new SceneDrop(m_bench->files(), this);
  // Before any face hears of it: what that arranges anew may resize the scene, whose old runs
  // are gone.
  connect(m_bench->controller(), &RunController::restarted, m_area,
          [this] { m_area->setRuns(m_bench->controller()->runs()); });
  makeFace();
  m_bench->start();
  memory().restore();
}

/// The face before the workbench and the docks: it works with them.
MainWindow::~MainWindow() {
  delete m_face;
}

void MainWindow::takeUsualSize() {
  const QSize available = screen()->availableSize();
  resize(kFirstSize.boundedTo(available));
  // The desktop's frame needs room, too.
  const QSize framed = kFirstSize + kFrame;
  if (framed.boundedTo(available) != framed) setWindowState(Qt::WindowMaximized);
}

void MainWindow::makeFace() {
  m_face = new WindowFace(this, m_bench, m_area);
  // Later: the menu in which it was chosen goes as well.
  connect(
      m_face, &WindowFace::languageChosen, this,
      [this](int language) { speak(static_cast<Language>(language)); }, Qt::QueuedConnection);
}

/// Leaves what does not belong to a language: the scene as it is looked at.
void MainWindow::removeFace() {
  m_area->setParent(this);
  delete m_face;
  delete menuBar();
  delete statusBar();
}

void MainWindow::speak(Language language) {
  Settings().setLanguage(language);
  m_face->presentation()->setOn(false);
  const FaceView view = m_face->view();
  const QSize usualSize = size();
  setUpdatesEnabled(false);
  setAnimated(false);
  removeFace();
  ui::speak(language);
  makeFace();
  m_bench->controller()->tellAgain();
  m_bench->selection()->tellAgain();
  for (QWidget* part : {static_cast<QWidget*>(menuBar()), static_cast<QWidget*>(statusBar()),
                        static_cast<QWidget*>(m_face), static_cast<QWidget*>(m_area)})
    part->show();
  m_face->setView(view);
  nameTabs();
  // Panels as wide as before may leave too little room to others, whose words are longer now.
  if (size() != usualSize) resize(usualSize);
  setAnimated(true);
  setUpdatesEnabled(true);
  m_area->setFocus();
}

WindowMemory MainWindow::memory() {
  return {this, m_face->commands(), m_bench->controller(), m_face->charts()};
}

void MainWindow::keepDraftsIn(const QString& folder) {
  m_bench->keepDraftsIn(folder);
  m_face->offerRecovery();
  m_bench->recovery()->start();
}

RunController* MainWindow::controller() const {
  return m_bench->controller();
}

SceneEditor* MainWindow::editor() const {
  return m_bench->editor();
}

Selection* MainWindow::selection() const {
  return m_bench->selection();
}

SceneFiles* MainWindow::files() const {
  return m_bench->files();
}

Exports* MainWindow::exports() const {
  return m_face->exports();
}

const Commands& MainWindow::commands() const {
  return m_face->commands();
}

ChartsPanel* MainWindow::charts() const {
  return m_face->charts();
}

Presentation* MainWindow::presentation() const {
  return m_face->presentation();
}

TargetControl* MainWindow::target() const {
  return m_face->target();
}

/// As the user left them, else as usual.
void MainWindow::sizePanels() {
  if (!restoreState(Settings().panels())) m_face->panels().sizeAsUsual(m_area->height());
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (event->spontaneous() || m_panelsSized) return;
  m_panelsSized = true;
  sizePanels();
  m_face->lessons()->begin();
}

/// Qt makes tabs for panels that share a place as it needs them.
void MainWindow::childEvent(QChildEvent* event) {
  QMainWindow::childEvent(event);
  if (event->polished()) nameTabs();
}

void MainWindow::nameTabs() const {
  for (QTabBar* tabs : findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
    tabs->setAccessibleName(tr("Panels"));
    tabs->setAccessibleDescription(tr("Which of the panels that share this place is shown"));
  }
}

void MainWindow::closeEvent(QCloseEvent* event) {
  event->setAccepted(m_bench->files()->mayLeaveScene());
  if (!event->isAccepted()) return;
  m_face->presentation()->setOn(false);
  memory().save();
  if (m_bench->drafts()) m_bench->drafts()->letGo();
}

}  // namespace ui
