#include "ui/panels/cut_window.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMimeData>
#include <QScreen>
#include <QSpinBox>
#include <QSplitter>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/chart/cut_sweep_chart.h"
#include "ui/control/background_task.h"
#include "ui/control/file_dialog.h"
#include "ui/control/run_words.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_target.h"
#include "ui/files/lessons.h"
#include "ui/files/output_file.h"
#include "ui/panels/export_message.h"
#include "ui/panels/hit_table.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/task_row.h"
#include "ui/panels/wheel_guard.h"
#include "ui/style/icons.h"

namespace ui {
namespace {

constexpr QSize kFirstSize(1360, 820);
constexpr core::Range kCutRange{0, 1000, "s"};
constexpr core::Range kPlaceRange{0, 1e5, "m"};
constexpr core::Range kWidthRange{1e-4, 1e5, "m"};
constexpr int kPause = 150;  // [ms]
/// Scenes with more weights take so long that the user is to ask.
constexpr std::size_t kMostByItself = 50;

/// What decides where a weight lands, whenever it is cut.
core::Scene withoutCut(core::Scene scene) {
  scene.cutTime.reset();
  scene.solvers.clear();
  return scene;
}

/// Enough for a fall from the ceiling, and back up there and down again.
double longestWait(const core::Scene& scene) {
  constexpr double kLeast = 10, kFalls = 4;
  if (scene.gravity <= 0) return kLeast;
  return std::max(kLeast, kFalls * std::sqrt(2 * scene.room.height / scene.gravity));
}

}  // namespace

struct CutWindow::Work {
  core::CutSweep sweep;
  core::Scene scene;
};

CutWindow::CutWindow(SceneEditor* editor, SceneTarget* target, QWidget* parent)
    : QDialog(parent),
      m_editor(editor),
      m_target(target),
      m_task(new BackgroundTask(this)),
      m_row(new TaskRow(m_task, tr("Find"))),
      m_weight(new QSpinBox),
      m_run(new QComboBox),
      m_center(new QuantityField({.range = kPlaceRange, .arrowStep = 0.1})),
      m_width(new QuantityField({.range = kWidthRange, .arrowStep = 0.05})),
      m_from(new QuantityField({.range = kCutRange, .arrowStep = 1})),
      m_until(new QuantityField({.range = kCutRange, .arrowStep = 1})),
      m_export(exportButton()),
      m_chart(new CutSweepChart),
      m_table(new HitTable),
      m_found(new QLabel),
      m_pause(new QTimer(this)) {
  setObjectName("whenToCut");
  setWindowTitle(tr("When to cut?"));
  setWindowFlag(Qt::WindowMaximizeButtonHint);
  buildControls();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(questionRow());
  layout->addWidget(m_row);
  layout->addWidget(resultArea(), 1);
  layout->addWidget(m_found);
  resize(kFirstSize.boundedTo(screen()->availableSize() * 0.95));
  listRuns();
  showTarget();
  forget();
}

CutWindow::~CutWindow() = default;

void CutWindow::buildControls() {
  m_weight->setAccessibleName(tr("Weight that is to hit the target"));
  m_weight->setToolTip(tr("Which weight, counted from the left"));
  m_run->setAccessibleName(tr("Method that finds the moments"));
  m_run->setToolTip(m_run->accessibleName());
  m_run->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  m_center->setName(tr("Center of the target"),
                    tr("Where the middle of the target lies, x in m from the left wall"));
  m_width->setName(tr("Width of the target"), tr("How wide the target is, in m"));
  m_from->setName(tr("First cut time"), tr("The earliest moment to cut, in s"));
  m_until->setName(tr("Last cut time"), tr("The latest moment to cut, in s"));
  m_from->setValue(m_firstCut);
  m_until->setValue(m_lastCut);
  m_row->add(tr("Cut between"), m_from);
  m_row->add(tr("and"), m_until);
  m_row->addLast(m_export);
  m_found->setWordWrap(true);
  m_found->setContentsMargins(12, 6, 12, 10);
  m_pause->setSingleShot(true);
  m_pause->setInterval(kPause);

  connect(m_weight, &QSpinBox::valueChanged, this,
          [this](int number) { m_target->setWeight(number - 1); });
  connect(m_run, &QComboBox::activated, this, &CutWindow::find);
  connect(m_center, &QuantityField::edited, this, [this](double center) {
    m_target->setPlace({center, m_target->place().width});
  });
  connect(m_width, &QuantityField::edited, this, [this](double width) {
    m_target->setPlace({m_target->place().center, width});
  });
  connect(m_from, &QuantityField::edited, this, [this](double time) {
    m_firstCut = time;
    if (findsByItself()) find();
  });
  connect(m_until, &QuantityField::edited, this, [this](double time) {
    m_lastCut = time;
    if (findsByItself()) find();
  });
  connect(m_row, &TaskRow::startWanted, this, &CutWindow::find);
  connect(m_chart, &CutSweepChart::momentPicked, this, &CutWindow::pick);
  connect(m_table, &HitTable::momentPicked, this, &CutWindow::pick);
  connect(m_editor, &SceneEditor::sceneChanged, this, &CutWindow::noteScene);
  connect(m_target, &SceneTarget::changed, this, &CutWindow::showTarget);
  connect(m_pause, &QTimer::timeout, this, [this] {
    m_wantsHits = true;
    goOn();
  });
  // Later: what has just ended still tells what it found.
  connect(m_task, &BackgroundTask::runningChanged, this, &CutWindow::goOn, Qt::QueuedConnection);
}

QWidget* CutWindow::questionRow() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(12, 8, 12, 0);
  layout->setSpacing(10);
  m_weight->setFocusPolicy(Qt::StrongFocus);
  ignoreWheelWithoutFocus(m_weight);
  layout->addWidget(new QLabel(tr("Weight")));
  layout->addWidget(m_weight);
  layout->addWidget(new QLabel(tr("by")));
  layout->addWidget(m_run);
  layout->addSpacing(20);
  layout->addWidget(new QLabel(tr("Target at")));
  layout->addWidget(m_center);
  layout->addWidget(new QLabel(tr("Width")));
  layout->addWidget(m_width);
  layout->addStretch(1);
  return row;
}

QToolButton* CutWindow::exportButton() {
  auto* button = new QToolButton;
  button->setText(tr("Export"));
  button->setToolTip(tr("Save the chart as a picture or its figures as a table"));
  button->setIcon(icon("save"));
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button);
  menu->addAction(icon("chart"), tr("Chart…"), this, [this] {
    const QString file = askWhereToSave(this, tr("Export chart"), suggested("png"), pictureKinds());
    if (!file.isEmpty()) saveChart(file);
  });
  menu->addAction(icon("table"), tr("Table…"), this, [this] {
    const QString file =
        askWhereToSave(this, tr("Export table"), suggested("csv"), {tr("Table (*.csv)")});
    if (!file.isEmpty()) saveTable(file);
  });
  menu->addSeparator();
  QAction* copyPicture =
      menu->addAction(icon("picture"), tr("Copy chart"), this, &CutWindow::copyChart);
  QAction* copyFigures =
      menu->addAction(icon("table"), tr("Copy chart data"), this, &CutWindow::copyData);
  copyPicture->setShortcut(QKeySequence("Ctrl+Shift+C"));
  copyFigures->setShortcut(QKeySequence("Ctrl+Shift+D"));
  addActions({copyPicture, copyFigures});
  button->setMenu(menu);
  return button;
}

QWidget* CutWindow::resultArea() {
  auto* splitter = new QSplitter(Qt::Horizontal);
  splitter->addWidget(m_chart);
  splitter->addWidget(m_table);
  constexpr int kChartShare = 640, kTableShare = 360;
  splitter->setSizes({kChartShare, kTableShare});
  return splitter;
}

void CutWindow::listRuns() {
  const int chosen = std::max(0, m_run->currentIndex());
  const auto& solvers = m_editor->scene()->solvers;
  m_run->clear();
  for (const core::Solver& solver : solvers) m_run->addItem(runWords(solver));
  m_run->setCurrentIndex(chosen < m_run->count() ? chosen : 0);
  const QSignalBlocker quiet(m_weight);
  m_weight->setRange(1, std::max(1, static_cast<int>(m_editor->scene()->weights.size())));
}

/// The band follows at once, the hits as soon as the target stays where it is.
void CutWindow::showTarget() {
  {
    const QSignalBlocker quiet(m_weight);
    m_weight->setValue(m_target->weight() + 1);
  }
  m_center->setValue(m_target->place().center);
  m_width->setValue(m_target->place().width);
  if (m_work && m_work->sweep.question().weight != m_target->weight()) return noteScene();
  if (!m_result || m_result->target == m_target->place()) return;
  auto moved = std::make_shared<CutSweepResult>(*m_result);
  moved->target = m_target->place();
  moved->hits.clear();
  m_result = std::move(moved);
  m_chart->setResult(m_result);
  m_table->setHits({});
  m_pause->start();
}

/// What was found belongs to another scene, unless only the cut is another one.
void CutWindow::noteScene() {
  listRuns();
  const auto& solvers = m_editor->scene()->solvers;
  const bool isCurrent = m_work && m_work->scene == withoutCut(*m_editor->scene()) &&
                         m_work->sweep.question().weight == m_target->weight() &&
                         std::ranges::count(solvers, m_work->sweep.solver()) > 0;
  if (isCurrent) return;
  forget();
  if (isVisible() && findsByItself()) find();
}

void CutWindow::forget() {
  m_task->cancel();
  m_work.reset();
  m_result.reset();
  m_export->setEnabled(false);
  m_chart->setResult(nullptr);
  m_table->setHits({});
  m_found->setText(
      tr("Finds where the weight first comes to the floor for every moment of the "
         "cut, and the moments that hit the target."));
}

void CutWindow::bringUp() {
  m_target->setShown(true);
  show();
  raise();
  activateWindow();
  if (!m_work && !m_task->isRunning() && findsByItself()) find();
}

bool CutWindow::findsByItself() const {
  return m_editor->scene()->weights.size() <= kMostByItself;
}

core::CutSweepQuestion CutWindow::question() const {
  return {.weight = m_target->weight(),
          .from = m_firstCut,
          .until = m_lastCut,
          .longestWait = longestWait(*m_editor->scene())};
}

void CutWindow::find() {
  if (m_editor->scene()->weights.empty()) return;
  if (m_lastCut <= m_firstCut) return m_until->mark(tr("must be later than the first"));
  m_until->clearMark();
  m_wantsSweep = true;
  goOn();
}

void CutWindow::goOn() {
  if (m_task->isRunning()) {
    if (m_wantsSweep) m_task->cancel();
  } else if (m_wantsSweep) {
    begin(true);
  } else if (m_wantsHits && m_work) {
    begin(false);
  }
}

void CutWindow::begin(bool sweepsAnew) {
  m_wantsSweep = m_wantsHits = false;
  std::shared_ptr<Work> work = m_work;
  if (sweepsAnew) {
    const core::Scene& scene = *m_editor->scene();
    const auto run = static_cast<std::size_t>(std::max(0, m_run->currentIndex()));
    work = std::make_shared<Work>(
        Work{core::CutSweep(scene, scene.solvers[run], question()), withoutCut(scene)});
  }
  const core::Target target = m_target->place();
  auto hits = std::make_shared<std::optional<std::vector<core::Hit>>>();
  m_task->start(
      [=](const core::Progress& progress) {
        constexpr double kShareOfCurve = 0.95;
        const auto curve = [&](double share) { return progress(kShareOfCurve * share); };
        if (sweepsAnew && !work->sweep.compute(curve)) return;
        *hits = work->sweep.hitsOn(target, [&](double) { return progress(kShareOfCurve); });
      },
      [=, this] {
        m_work = work;
        finish(**hits, target);
      });
}

void CutWindow::finish(const std::vector<core::Hit>& hits, const core::Target& target) {
  const core::CutSweep& sweep = m_work->sweep;
  auto result = std::make_shared<CutSweepResult>();
  result->question = sweep.question();
  result->solver = sweep.solver();
  result->room = m_work->scene.room;
  result->sceneName = titleOf(m_work->scene);
  result->landings = sweep.landings();
  result->isResolved = sweep.isResolved();
  result->target = target;
  result->hits = hits;
  std::ranges::stable_sort(result->hits, std::ranges::greater(),
                           [](const core::Hit& hit) { return hit.until - hit.from; });
  m_result = std::move(result);
  m_export->setEnabled(true);
  m_chart->setResult(m_result);
  m_table->setHits(m_result->hits);
  m_found->setText(foundWords(*m_result));
  if (target == m_target->place()) return;
  m_wantsHits = true;
  goOn();
}

void CutWindow::pick(double cutTime) {
  const bool isTaken = m_editor->change([&](core::Scene& scene) { scene.cutTime = cutTime; },
                                        [] { return tr("change of the cut"); });
  if (!isTaken) return;
  m_found->setText(tr("All ropes are cut at %1 s now. Play to see where weight %2 lands.")
                       .arg(cutTimeText(cutTime))
                       .arg(m_target->weight() + 1));
  emit momentPicked(cutTime);
}

void CutWindow::saveChart(const QString& file) {
  sayIfNotExported(this, file, writeCutSweepChart(file, m_result));
}

void CutWindow::saveTable(const QString& file) {
  const std::string table = sweepTable(*m_result, ',', QStringLiteral(".")).toStdString();
  sayIfNotExported(this, file, writeWhole(file, table));
}

void CutWindow::copyChart() const {
  if (m_result) QGuiApplication::clipboard()->setImage(cutSweepImage(m_result));
}

void CutWindow::copyData() const {
  if (!m_result) return;
  auto* table = new QMimeData;
  table->setText(sweepTable(*m_result, '\t', QLocale().decimalPoint()));
  table->setData(QStringLiteral("text/csv"),
                 sweepTable(*m_result, ',', QStringLiteral(".")).toUtf8());
  QGuiApplication::clipboard()->setMimeData(table);
}

QString CutWindow::suggested(const QString& ending) const {
  return fileNameFrom(m_result->sceneName) + '-' + tr("when-to-cut") + '.' + ending;
}

}  // namespace ui
