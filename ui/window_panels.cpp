#include "ui/window_panels.h"

#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QToolBar>

#include "ui/control/commands.h"
#include "ui/panels/charts_panel.h"
#include "ui/panels/comparison_panel.h"
#include "ui/panels/events_panel.h"
#include "ui/panels/form_area.h"
#include "ui/panels/lesson_panel.h"
#include "ui/panels/panel_title.h"
#include "ui/panels/runs_form.h"
#include "ui/panels/scene_form.h"
#include "ui/panels/selection_links.h"
#include "ui/panels/step_panel.h"
#include "ui/panels/weights_form.h"
#include "ui/panels/weights_table.h"
#include "ui/view/scene_area.h"
#include "ui/workbench.h"

namespace ui {
namespace {

constexpr double kChartShare = 0.4;  // of the height that scene and chart have together

struct Titles {
  Q_DECLARE_TR_FUNCTIONS(ui::WindowPanels)
};

}  // namespace

WindowPanels::WindowPanels(QMainWindow* window, const Workbench& bench, const Commands& commands,
                           SceneArea* view)
    : m_window(window) {
  window->setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window->setTabPosition(Qt::LeftDockWidgetArea, QTabWidget::North);
  addForms(bench, commands);
  addBelow(bench, commands, view);
}

WindowPanels::~WindowPanels() {
  qDeleteAll(m_docks);
}

void WindowPanels::addForms(const Workbench& bench, const Commands& commands) {
  m_lesson = new LessonPanel(commands);
  m_weights = new WeightsForm(bench.editor());
  auto* sceneForm = new SceneForm(bench.editor());
  // The methods are what the program is about.
  auto* runsArea = new FormArea(new RunsForm(bench.editor()), FormArea::Height::kWhole);
  const Qt::DockWidgetArea side = Qt::LeftDockWidgetArea;
  m_lessonDock = add(side, "lesson", Titles::tr("Lesson"), new FormArea(m_lesson));
  QDockWidget* scene = add(side, "scene", Titles::tr("Scene"), new FormArea(sceneForm));
  QDockWidget* weights = add(side, "weights", Titles::tr("Weights"), new FormArea(m_weights));
  m_runsDock = add(side, "runs", Titles::tr("Runs"), runsArea);
  m_window->tabifyDockWidget(m_lessonDock, scene);
  m_window->tabifyDockWidget(scene, weights);
  // Their tabs are their titles.
  for (QDockWidget* dock : {m_lessonDock, scene, weights})
    dock->setTitleBarWidget(new QWidget(dock));
  m_runsDock->setTitleBarWidget(new PanelTitle(m_runsDock, nullptr));
  scene->raise();
}

void WindowPanels::addBelow(const Workbench& bench, const Commands& commands, SceneArea* view) {
  m_charts = new ChartsPanel(bench.controller(), commands);
  auto* comparison = new ComparisonPanel(bench.controller());
  auto* step = new StepPanel(bench.controller());
  m_events = new EventsPanel(bench.controller(), bench.events());
  m_table = new WeightsTable(bench.editor(), bench.selection());
  const Qt::DockWidgetArea below = Qt::BottomDockWidgetArea;
  m_chartsDock = add(below, "charts", Titles::tr("Charts"), m_charts);
  QDockWidget* compared = add(below, "comparison", Titles::tr("Comparison"), comparison);
  m_window->tabifyDockWidget(m_chartsDock, compared);
  QDockWidget* opened = add(below, "step", Titles::tr("Inside a step"), step);
  m_window->tabifyDockWidget(compared, opened);
  QDockWidget* events = add(below, "events", Titles::tr("Events"), m_events);
  QDockWidget* table = add(below, "weightsTable", Titles::tr("Weights table"), m_table);
  m_window->tabifyDockWidget(opened, table);
  m_window->tabifyDockWidget(m_chartsDock, events);
  m_chartsDock->setTitleBarWidget(new PanelTitle(m_chartsDock, m_charts->choosers()));
  compared->setTitleBarWidget(new PanelTitle(compared, comparison->chooser()));
  opened->setTitleBarWidget(new PanelTitle(opened, step->choosers()));
  events->setTitleBarWidget(new PanelTitle(events, m_events->filters()));
  table->setTitleBarWidget(new PanelTitle(table, m_table->buttons()));
  QObject::connect(opened, &QDockWidget::visibilityChanged, step, &StepPanel::setSeen);
  QObject::connect(step, &StepPanel::stepOpened, view, &SceneArea::showStep);
  linkSelection(bench.selection(), bench.editor(), {m_weights, step, m_charts, m_events});
  linkTable(commands, table);
  m_chartsDock->raise();
}

void WindowPanels::linkTable(const Commands& commands, QDockWidget* dock) const {
  const QAction* show = commands.action(Command::kWeightsTable);
  QObject::connect(show, &QAction::triggered, dock, [dock, table = m_table] {
    dock->show();
    dock->raise();
    table->takeKeyboard();
  });
  QObject::connect(m_weights, &WeightsForm::tableWanted, show, &QAction::trigger);
}

QDockWidget* WindowPanels::add(Qt::DockWidgetArea area, const char* name, const QString& title,
                               QWidget* content) {
  auto* dock = new QDockWidget(title, m_window);
  dock->setObjectName(name);
  dock->setWidget(content);
  m_window->addDockWidget(area, dock);
  // Qt leaves panels that stand behind another tab visible, out of sight: hidden they need not
  // compute what they show, which saves a few ms in every frame of 10,000 weights.
  QSizePolicy policy = content->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  content->setSizePolicy(policy);
  QObject::connect(dock, &QDockWidget::visibilityChanged, content, &QWidget::setVisible);
  m_docks.push_back(dock);
  return dock;
}

void WindowPanels::listIn(QMenu* menu) const {
  for (const QDockWidget* dock : m_docks) menu->addAction(dock->toggleViewAction());
}

void WindowPanels::sizeAsUsual(int sceneHeight) const {
  const int shared = sceneHeight + m_chartsDock->height();
  m_window->resizeDocks({m_chartsDock}, {static_cast<int>(shared * kChartShare)}, Qt::Vertical);
  m_window->resizeDocks({m_runsDock}, {m_runsDock->sizeHint().height()}, Qt::Vertical);
}

}  // namespace ui
