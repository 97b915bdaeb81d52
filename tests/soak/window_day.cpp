#include "tests/soak/window_day.h"

#include <chrono>
#include <malloc.h>

#include <QAction>
#include <QApplication>
#include <QDeadlineTimer>
#include <QSettings>
#include <QTemporaryDir>
#include <QThread>

#include "ui/control/commands.h"
#include "ui/control/draft_keeper.h"
#include "ui/control/exports.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"
#include "ui/panels/cut_window.h"

using ui::Command;

namespace {

constexpr double kFrame = 0.1;  // s of wall time: the most a frame may stand for
constexpr double kSpeed = 60;   // so that a frame shows 6 s
constexpr int kChartKinds = 8;  // at most

/// Lets go, too, of what goes once the event loop is idle.
void settle() {
  for (int round = 0; round < 3; ++round) {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QCoreApplication::processEvents();
  }
}

}  // namespace

WindowDay::WindowDay(int lessons)
    : m_lessons(lessons), m_folder(std::make_unique<QTemporaryDir>()) {
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder->path());
  m_window = std::make_unique<ui::MainWindow>(ui::builtInScene(QStringLiteral("seven-weights")));
  m_window->resize(1280, 720);
  m_window->keepDraftsIn(m_folder->filePath(QStringLiteral("drafts")));
  m_window->show();
  // Time passes by the frame, and a frame takes as long as it takes.
  ui::RunController* controller = m_window->controller();
  QObject::disconnect(controller, &ui::RunController::busyChanged, nullptr, nullptr);
  controller->setStopwatch([] { return 0.0; });
  controller->setSpeed(kSpeed);
}

WindowDay::~WindowDay() = default;

void WindowDay::spendHour(double seconds) {
  const QStringList lessons = ui::builtInScenes().mid(0, m_lessons);
  // Half of it with one scene, whose record grows long.
  playLesson(lessons.first(), seconds / 2);
  for (const QString& lesson : lessons)
    playLesson(lesson, seconds / 2 / static_cast<double>(lessons.size()));
  lookAround();
  writeFiles();
  showWhenToCut();
  changeAndUndo();
  settle();
}

void WindowDay::playLesson(const QString& name, double seconds) {
  m_window->files()->openBuiltIn(name);
  ui::RunController* controller = m_window->controller();
  controller->play();
  const int frames = static_cast<int>(seconds / (kFrame * kSpeed)) + 1;
  for (int frame = 0; frame < frames; ++frame) {
    if (frame == frames / 2) m_window->commands().action(Command::kCut)->trigger();
    controller->passTime(kFrame);
    QCoreApplication::processEvents();
  }
  controller->pause();
  controller->showTime(controller->time() / 2);
  QCoreApplication::processEvents();
}

void WindowDay::lookAround() {
  const auto trigger = [this](Command command) {
    m_window->commands().action(command)->trigger();
    QCoreApplication::processEvents();
  };
  for (int chart = 0; chart < kChartKinds; ++chart) trigger(Command::kNextChart);
  for (const Command twice : {Command::kSplit, Command::kPresent, Command::kForces,
                              Command::kTensions, Command::kTape, Command::kTarget}) {
    trigger(twice);
    trigger(twice);
  }
  for (const Command once : {Command::kCopyChart, Command::kCopyChartData, Command::kNextEvent,
                             Command::kNextWeight, Command::kStepBack, Command::kReset}) {
    trigger(once);
  }
}

void WindowDay::writeFiles() {
  ui::Exports* exports = m_window->exports();
  for (const char* ending : {"png", "svg", "pdf"}) {
    exports->saveChart(m_folder->filePath(QStringLiteral("chart.") + ending));
    exports->savePicture(m_folder->filePath(QStringLiteral("picture.") + ending));
  }
  exports->saveLedger(m_folder->filePath(QStringLiteral("ledger.csv")), 0);
  const QString scene = m_folder->filePath(QStringLiteral("scene.json"));
  m_window->files()->saveTo(scene);
  m_window->files()->open(scene);
}

/// Beside the window, and searched to the end.
void WindowDay::showWhenToCut() {
  m_window->files()->openBuiltIn(QStringLiteral("one-pendulum"));
  m_window->commands().action(Command::kWhenToCut)->trigger();
  QCoreApplication::processEvents();
  for (auto* window : m_window->findChildren<ui::CutWindow*>()) window->close();
}

/// Undone as far as it goes: steps that can be undone are kept on purpose, up to their limit.
void WindowDay::changeAndUndo() {
  ui::SceneEditor* editor = m_window->editor();
  for (int i = 1; i <= 10; ++i) editor->change([i](core::Scene& draft) { draft.gravity = i; });
  m_window->findChild<ui::DraftKeeper*>()->keepAndWait();
  while (editor->canUndo()) editor->undo();
  // What could be done again is forgotten by this.
  editor->change([](core::Scene& draft) { draft.gravity = 9; });
  editor->setSaved();
}

/// Charts catch up after a pause, which ends when the machine has time for it.
void WindowDay::waitUntilStill() const {
  constexpr int kPause = 50;  // [ms]
  constexpr int kAlike = 10;
  QDeadlineTimer patience(std::chrono::seconds(30));
  int before = -1;
  for (int alike = 0; alike < kAlike && !patience.hasExpired();) {
    QThread::msleep(kPause);
    settle();
    alike = objectCount() == before ? alike + 1 : 0;
    before = objectCount();
  }
}

int WindowDay::objectCount() const {
  return static_cast<int>(m_window->findChildren<QObject*>().size());
}

WindowFigures WindowDay::figures() const {
  waitUntilStill();
  malloc_trim(0);
  return {.process = figuresNow(),
          .objects = objectCount(),
          .windows = static_cast<int>(QApplication::topLevelWidgets().size())};
}
