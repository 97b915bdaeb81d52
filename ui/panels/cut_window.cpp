#include "ui/panels/cut_window.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include <QScreen>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/control/background_task.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_target.h"
#include "ui/files/lessons.h"
#include "ui/panels/cut_questions.h"
#include "ui/panels/cut_results.h"
#include "ui/panels/export_button.h"
#include "ui/panels/task_row.h"

namespace ui {
namespace {

constexpr QSize kFirstSize(1360, 820);
constexpr int kPause = 150;  // [ms]
/// Scenes with more weights take so long that the user is to ask.
constexpr std::size_t kMostByItself = 50;

/// What decides where a weight lands, whenever it is cut.
core::Scene withoutCut(core::Scene scene) {
  scene.cutTime.reset();
  scene.solvers.clear();
  return scene;
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
      m_questions(new CutQuestions(editor, target, m_row)),
      m_results(new CutResults),
      m_pause(new QTimer(this)) {
  setObjectName("whenToCut");
  setWindowTitle(tr("When to cut?"));
  setWindowFlag(Qt::WindowMaximizeButtonHint);
  m_row->addLast(m_results->exportButton());
  m_pause->setSingleShot(true);
  m_pause->setInterval(kPause);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_questions);
  layout->addWidget(m_row);
  layout->addWidget(m_results, 1);
  resize(kFirstSize.boundedTo(screen()->availableSize() * 0.95));
  connectParts();
}

CutWindow::~CutWindow() = default;

void CutWindow::connectParts() {
  connect(m_questions, &CutQuestions::runChosen, this, &CutWindow::find);
  connect(m_questions, &CutQuestions::timesChanged, this, [this] {
    if (findsByItself()) find();
  });
  connect(m_row, &TaskRow::startWanted, this, &CutWindow::find);
  connect(m_results, &CutResults::momentPicked, this, &CutWindow::pick);
  connect(m_editor, &SceneEditor::sceneChanged, this, &CutWindow::noteScene);
  connect(m_target, &SceneTarget::changed, this, &CutWindow::noteTarget);
  connect(m_pause, &QTimer::timeout, this, [this] {
    m_wantsHits = true;
    goOn();
  });
  // Later: what has just ended still tells what it found.
  connect(m_task, &BackgroundTask::runningChanged, this, &CutWindow::goOn, Qt::QueuedConnection);
}

const std::shared_ptr<const CutSweepResult>& CutWindow::result() const {
  return m_results->result();
}

/// The band follows at once, the hits as soon as the target stays where it is.
void CutWindow::noteTarget() {
  m_questions->showTarget();
  if (m_work && m_work->sweep.question().weight != m_target->weight()) return noteScene();
  if (!result() || result()->target == m_target->place()) return;
  m_results->showTarget(m_target->place());
  m_pause->start();
}

/// What was found belongs to another scene, unless only the cut is another one.
void CutWindow::noteScene() {
  m_questions->listRuns();
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
  m_results->setResult(nullptr);
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

void CutWindow::find() {
  if (m_editor->scene()->weights.empty() || !m_questions->checkTimes()) return;
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
    work = std::make_shared<Work>(
        Work{core::CutSweep(scene, scene.solvers[m_questions->run()], m_questions->question()),
             withoutCut(scene)});
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
  m_results->setResult(std::move(result));
  if (target == m_target->place()) return;
  m_wantsHits = true;
  goOn();
}

void CutWindow::pick(double cutTime) {
  const bool isTaken = m_editor->change([&](core::Scene& scene) { scene.cutTime = cutTime; },
                                        [] { return tr("change of the cut"); });
  if (!isTaken) return;
  m_results->say(tr("All ropes are cut at %1 s now. Play to see where weight %2 lands.")
                     .arg(cutTimeText(cutTime))
                     .arg(m_target->weight() + 1));
  emit momentPicked(cutTime);
}

}  // namespace ui
