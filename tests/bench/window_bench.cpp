// The whole window playing weights that touch nothing, two runs of them, the energy chart open
// and panels as at the first start: frames per second, and what the processor does in one [ms].
//
//     window_bench                         with the QPainter painter, then with OpenGL
//     window_bench qpainter [WEIGHTS …]    without a display
//     window_bench opengl [WEIGHTS …]      on the display there is; needs OpenGL 3.3
//     window_bench first-frame             opens it with the demonstration, says so, and ends

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>

#include "ui/control/first_scene.h"
#include "ui/control/run_controller.h"
#include "ui/control/settings.h"
#include "ui/main_window.h"
#include "ui/view/scene_area.h"

namespace {

constexpr double kWarmUp = 1;      // s
constexpr double kMeasured = 4;    // s
constexpr QSize kSize(1600, 900);  // px

double secondsOf(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wallTime() {
  return secondsOf(CLOCK_MONOTONIC);
}

/// The processor's time of the window's thread.
double windowTime() {
  return secondsOf(CLOCK_THREAD_CPUTIME_ID);
}

/// Weights on ropes too short to meet, or flying apart from the middle of a large room.
core::Scene loneWeights(int count, bool onRopes) {
  core::Scene scene;
  const int columns = std::max(4, static_cast<int>(std::ceil(std::sqrt(count))));
  const double size = onRopes ? columns : 4 * columns;
  scene.room = {.width = size, .height = size + 1};
  scene.gravity = onRopes ? 9.81 : 0;
  for (int i = 0; i < count; ++i) {
    core::Weight weight;
    weight.radius = 0.05;
    const int row = i / columns;
    const Eigen::Vector2d cell(i % columns + 0.5, row + 0.5);
    if (onRopes) {
      weight.rope = core::Rope{.pivot = cell, .length = 0.4, .angle = 0.3 + i % 7 * 0.1};
    } else {
      const Eigen::Vector2d middle = Eigen::Vector2d::Constant(columns / 2.0);
      weight.position = cell + Eigen::Vector2d::Constant(1.5 * columns);
      weight.velocity = 0.1 * (cell - middle);
    }
    scene.weights.push_back(weight);
  }
  scene.solvers = {{.method = "rk4"}, {.method = "euler"}};
  return scene;
}

/// What the window's thread did in all frames [s].
struct Work {
  int frames = 0;
  double simulation = 0;  // steps, and recording them
  double reading = 0;     // of places, energies and events, to be shown
  double scene = 0;
  double charts = 0;
  double others = 0;
};

/// Notes whose painting takes how long.
class Application : public QApplication {
 public:
  using QApplication::QApplication;

  Work work;

  bool notify(QObject* receiver, QEvent* event) override {
    if (event->type() != QEvent::Paint || !receiver->isWidgetType())
      return QApplication::notify(receiver, event);
    const double start = windowTime();
    const bool done = QApplication::notify(receiver, event);
    shareOf(static_cast<QWidget*>(receiver)) += windowTime() - start;
    return done;
  }

 private:
  double& shareOf(const QWidget* widget) {
    for (; widget; widget = widget->parentWidget()) {
      if (qobject_cast<const ui::SceneArea*>(widget)) return work.scene;
      if (widget->objectName() == QLatin1String("charts")) return work.charts;
    }
    return work.others;
  }
};

/// Plays as the window's own ticker does, and notes what goes into the steps.
void playFor(double seconds, ui::RunController& controller, Work& work) {
  constexpr double kFrame = 1.0 / 60;
  double lastLook = 0;
  controller.setStopwatch([&lastLook] {
    lastLook = windowTime();
    return wallTime();
  });
  const double end = wallTime() + seconds;
  double lastFrame = wallTime() - kFrame;
  while (wallTime() < end) {
    QCoreApplication::processEvents(QEventLoop::AllEvents);
    const double elapsed = wallTime() - lastFrame;
    if (elapsed < kFrame) continue;
    lastFrame += elapsed;
    const double start = windowTime();
    controller.passTime(elapsed);
    work.simulation += lastLook - start;
    work.reading += windowTime() - lastLook;
    ++work.frames;
  }
  controller.setStopwatch(wallTime);
}

void report(Application& application, int count, bool onRopes) {
  ui::MainWindow window(loneWeights(count, onRopes));
  window.resize(kSize);
  window.show();
  ui::RunController& controller = *window.controller();
  Work& work = application.work;
  // Its own ticker would play as well.
  QObject::disconnect(&controller, &ui::RunController::busyChanged, nullptr, nullptr);
  controller.play();
  playFor(kWarmUp, controller, work);
  const double simulated = controller.time();
  work = {};
  const double start = wallTime();
  playFor(kMeasured, controller, work);
  const double wall = wallTime() - start;
  const double each = 1e3 / work.frames;
  std::printf("%8d %8s %10.0f %10.2f %10.1f %10.1f %10.1f %10.1f %10.1f %10.1f\n", count,
              onRopes ? "ropes" : "flight", work.frames / wall,
              (controller.time() - simulated) / wall,
              each * (work.simulation + work.reading + work.scene + work.charts + work.others),
              each * work.simulation, each * work.reading, each * work.scene, each * work.charts,
              each * work.others);
  std::fflush(stdout);
}

/// Opens the window as the program does, and says when its scene has been painted.
int paintFirstFrame(Application& application) {
  const ui::FirstScene first = ui::firstScene(QStringLiteral("seven-weights"));
  if (!first.scene) return EXIT_FAILURE;
  ui::MainWindow window(*first.scene, first.file);
  window.show();
  while (application.work.scene == 0) QCoreApplication::processEvents();
  std::puts("painted");
  return EXIT_SUCCESS;
}

/// Both painters, each in a program of its own.
int measureBoth(const std::string& self) {
  const std::string without = "QT_QPA_PLATFORM=offscreen '" + self + "' qpainter";
  const std::string with =
      "QT_QPA_PLATFORM=xcb xvfb-run -a -s '-screen 0 1920x1080x24 +extension "
      "GLX' '" +
      self + "' opengl";
  return std::system(without.c_str()) == 0 && std::system(with.c_str()) == 0 ? EXIT_SUCCESS
                                                                             : EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return measureBoth(argv[0]);
  const bool openGl = std::strcmp(argv[1], "opengl") == 0;
  Application application(argc, argv);
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  if (std::strcmp(argv[1], "first-frame") == 0) return paintFirstFrame(application);
  ui::Settings().setPainter(openGl ? ui::PainterChoice::kOpenGl : ui::PainterChoice::kQPainter);
  std::vector<int> counts;
  for (int i = 2; i < argc; ++i) counts.push_back(std::atoi(argv[i]));
  if (counts.empty()) counts = {7, 100, 1000, 10000};
  std::printf("%s: frames and simulated seconds per second; the window's work per frame [ms]\n",
              argv[1]);
  std::printf("%8s %8s %10s %10s %10s %10s %10s %10s %10s %10s\n", "weights", "on", "frames/s",
              "pace", "all", "simulation", "reading", "scene", "charts", "others");
  for (const int count : counts)
    for (const bool onRopes : {true, false}) report(application, count, onRopes);
  return EXIT_SUCCESS;
}
