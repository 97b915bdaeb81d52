#include "app/demonstration.h"

#include <memory>
#include <utility>
#include <vector>

#include <QCoreApplication>

#include "app/energy_history.h"
#include "app/run_tables.h"
#include "core/run/run.h"
#include "core/scene/scene_limits.h"
#include "ui/chart/chart_export.h"
#include "ui/control/run_words.h"
#include "ui/files/scene_file.h"
#include "ui/view/scene_picture.h"

namespace app {

namespace {

constexpr double kUntil = 10;          // simulated time [s]
constexpr double kFlightBefore = 0.4;  // between the cut and the picture [s]
constexpr double kPictureUncut = 1;    // of a scene that is never cut [s]

constexpr QLatin1StringView kChartFile("angrycuts-energy.png");
constexpr QLatin1StringView kTrajectoryFile("angrycuts-trajectory.csv");
constexpr QLatin1StringView kPictureFile("angrycuts-scene.png");

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(app::Demonstration)
};

QString numberWords(double number) {
  return QString::fromStdString(core::numberText(number));
}

SimulateCall tablesWanted() {
  SimulateCall call;
  call.until = kUntil;
  call.trajectory = kTrajectoryFile;
  return call;
}

/// The scene's runs side by side.
class Demonstration {
 public:
  explicit Demonstration(const std::shared_ptr<const core::Scene>& scene)
      : m_scene(scene), m_tables(tablesWanted()) {
    for (const core::Solver& solver : solversOf(*scene)) {
      m_runs.emplace_back(scene, solver);
      m_histories.emplace_back(kUntil);
    }
  }

  ExitStatus run() {
    if (!m_tables.open()) return failure(kFailed, m_tables.error());
    simulateUntil(pictureTime());
    const QString pictureError = writePicture();
    if (!pictureError.isEmpty()) return failure(kFailed, kPictureFile + ": " + pictureError);
    simulateUntil(kUntil);
    if (!m_tables.finish(m_runs.front())) return failure(kFailed, m_tables.error());
    const QString chartError = writeChart();
    if (!chartError.isEmpty()) return failure(kFailed, kChartFile + ": " + chartError);
    return printed(summary());
  }

 private:
  static std::vector<core::Solver> solversOf(const core::Scene& scene) {
    if (!scene.solvers.empty()) return scene.solvers;
    return {{.method = "rk4"}, {.method = "euler"}};
  }

  double pictureTime() const {
    return m_scene->cutTime ? std::min(*m_scene->cutTime + kFlightBefore, kUntil) : kPictureUncut;
  }

  void simulateUntil(double time) {
    for (std::size_t i = 0; i < m_runs.size(); ++i) simulate(i, time);
  }

  void simulate(std::size_t index, double time) {
    core::Run& run = m_runs[index];
    if (run.stepCount() == 0) record(index);
    while (run.time() < time && run.advance() == core::RunStatus::kRunning) record(index);
  }

  void record(std::size_t index) {
    m_histories[index].record(m_runs[index]);
    if (index == 0) m_tables.record(m_runs[index]);
  }

  /// Runs that ended early are left out: they have no state at that moment.
  QString writePicture() const {
    std::vector<const core::Run*> shown;
    for (const core::Run& run : m_runs) {
      if (run.time() >= pictureTime()) shown.push_back(&run);
    }
    if (shown.empty()) return Texts::tr("every method diverged before %1 s").arg(pictureTime());
    return ui::writeScenePicture(kPictureFile, shown, pictureTime());
  }

  QString writeChart() const {
    std::vector<ui::ChartedRun> charted;
    for (std::size_t i = 0; i < m_runs.size(); ++i) {
      charted.push_back({&m_histories[i].ledger(), ui::runWords(m_runs[i].solver())});
    }
    return ui::writeEnergyChart(kChartFile, charted,
                                {QString::fromStdString(m_scene->name), QString()});
  }

  QString summary() const {
    QStringList names;
    for (const core::Run& run : m_runs) names.append(ui::runWords(run.solver()));
    return Texts::tr(
               "There is no display for the window, so \"%1\" was simulated for %2 s.\n"
               "%3: energy with %4\n"
               "%5: where every weight is, with %6\n"
               "%7: the scene at %8 s\n")
        .arg(QString::fromStdString(m_scene->name), numberWords(kUntil), kChartFile,
             names.join(Texts::tr(" and ")), kTrajectoryFile, names.front(), kPictureFile,
             numberWords(pictureTime()));
  }

  std::shared_ptr<const core::Scene> m_scene;
  RunTables m_tables;
  std::vector<core::Run> m_runs;
  std::vector<EnergyHistory> m_histories;
};

}  // namespace

ExitStatus runDemonstration(const QString& scene) {
  ui::SceneOrError read = ui::readFileOrBuiltIn(scene);
  if (!read.scene) return failure(kRefused, scene + QStringLiteral(": ") + read.error);
  return Demonstration(std::make_shared<const core::Scene>(std::move(*read.scene))).run();
}

}  // namespace app
