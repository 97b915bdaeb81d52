// What stays, grows or drifts when things go on for long: hours simulated, large files, a day of
// the window. Prints figures; takes about a quarter of an hour. Run by tests/soak/run.
//
//     soak                    everything
//     soak runs               an hour each of seven weights that never rest, and of a heap
//     soak files              many weights, and a million rows
//     soak window [HOURS]     a day of the window, or so many hours

#include <cstdio>
#include <cstdlib>
#include <string>

#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>

#include "tests/soak/long_run.h"
#include "tests/soak/process_figures.h"
#include "tests/soak/window_day.h"
#include "tests/support/crowded_file.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"

namespace {

constexpr double kHour = 3600;  // s

void reportRun(const char* name, const std::shared_ptr<const core::Scene>& scene) {
  for (const bool isRecorded : {false, true}) {
    std::printf("\nAn hour of %s, %s history\n", name, isRecorded ? "with" : "without");
    std::printf("%8s %12s %12s %10s %12s %10s\n", "min", "drift", "overlap m", "events",
                "resident MiB", "heap MiB");
    runLong(scene, kHour, kHour / 6, isRecorded, [](const LongRunFigures& figures) {
      std::printf("%8.0f %12.1e %12.1e %10lld %12.1f %10.1f\n", figures.time / 60, figures.drift,
                  figures.overlap, static_cast<long long>(figures.events),
                  figures.process.residentMiB, figures.process.heapMiB);
      std::fflush(stdout);
    });
  }
}

void reportRuns() {
  reportRun("seven weights, e = 1, no air", sevenThatNeverRest());
  reportRun("a heap of 42", pileThatRests());
}

void reportCommand(const char* words, const std::vector<std::string>& arguments) {
  std::vector<std::string> command{ANGRYCUTS_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const Ended ended = runToEnd(command);
  std::printf("%-52s %9lld rows, %6.2f s, at most %6.1f MiB\n", words,
              static_cast<long long>(ended.lines - 1), ended.seconds, ended.peakMiB);
  std::fflush(stdout);
}

void reportOpening(const QString& file) {
  core::Scene small;
  small.weights.resize(1);
  small.weights.front().position = {1, 1};
  small.solvers = {{.method = "rk4"}};
  ui::MainWindow window(small);
  window.show();
  QCoreApplication::processEvents();
  QElapsedTimer timer;
  timer.start();
  window.files()->open(file);
  QCoreApplication::processEvents();
  std::printf("%-52s %zu weights, %6.2f s, then %6.1f MiB\n", "opened in the window",
              window.editor()->scene()->weights.size(), static_cast<double>(timer.elapsed()) / 1e3,
              figuresNow().residentMiB);
}

void reportFiles() {
  const QTemporaryDir folder;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
  const QString crowd = folder.filePath(QStringLiteral("crowd.json"));
  QFile file(crowd);
  if (!file.open(QIODevice::WriteOnly)) qFatal("no room for a file");
  file.write(oneLineOf(100'000));
  file.close();
  std::printf("\nA scene file with 100,000 weights, %.1f MiB\n",
              static_cast<double>(file.size()) / (1 << 20));
  reportOpening(crowd);
  const std::string scene = crowd.toStdString();
  reportCommand("simulated, one moment", {"simulate", scene, "--until", "0", "--trajectory", "-"});
  reportCommand("simulated, 11 moments", {"simulate", scene, "--until", "1", "--trajectory", "-"});
  std::printf("\nSeven weights, trajectory as rows\n");
  for (const char* until : {"14.2857", "142.857", "1428.57"}) {
    reportCommand(
        (std::string("a row of each in a millisecond, s: ") + until).c_str(),
        {"simulate", "seven-weights", "--until", until, "--sample", "0.001", "--trajectory", "-"});
  }
}

void reportWindow(int hours) {
  std::printf("\nThe window, %d hours simulated in it\n", hours);
  std::printf("%8s %12s %10s %8s %8s %8s %8s\n", "hour", "resident MiB", "heap MiB", "handles",
              "threads", "objects", "windows");
  WindowDay day(static_cast<int>(ui::builtInScenes().size()));
  for (int hour = 1; hour <= hours; ++hour) {
    day.spendHour(kHour);
    const WindowFigures now = day.figures();
    std::printf("%8d %12.1f %10.1f %8d %8d %8d %8d\n", hour, now.process.residentMiB,
                now.process.heapMiB, now.process.handles, now.process.threads, now.objects,
                now.windows);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const QApplication application(argc, argv);
  const std::string part = argc > 1 ? argv[1] : "";
  if (part.empty() || part == "runs") reportRuns();
  if (part.empty() || part == "files") reportFiles();
  if (part.empty() || part == "window") reportWindow(argc > 2 ? std::atoi(argv[2]) : 24);
  return EXIT_SUCCESS;
}
