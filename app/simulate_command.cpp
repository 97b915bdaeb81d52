#include "app/simulate_command.h"

#include <memory>
#include <optional>
#include <utility>

#include <QCoreApplication>

#include "app/energy_history.h"
#include "app/run_tables.h"
#include "core/run/run.h"
#include "core/scene/scene_limits.h"
#include "core/trade/stability.h"
#include "ui/chart/chart_export.h"
#include "ui/control/run_words.h"
#include "ui/files/scene_file.h"

namespace app {

namespace {

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(app::SimulateCommand)
};

/// One simulation as a call wants it.
class Simulation {
 public:
  Simulation(const SimulateCall& call, std::shared_ptr<const core::Scene> scene)
      : m_call(call),
        m_scene(std::move(scene)),
        m_run(m_scene, call.solver),
        m_tables(call),
        m_history(call.until) {}

  ExitStatus run() {
    if (!m_tables.open()) return failure(kFailed, m_tables.error());
    if (!chartCanBeWritten()) return kFailed;
    if (!simulate() || !m_tables.finish(m_run)) return failure(kFailed, m_tables.error());
    const ExitStatus shown = showResult();
    return shown == kSuccess ? outcome() : shown;
  }

 private:
  /// Found out before the work, not after it.
  bool chartCanBeWritten() const {
    if (m_call.chart.isEmpty()) return true;
    ui::OutputFile trial;
    if (trial.open(m_call.chart)) return true;
    failure(kFailed, m_call.chart + QStringLiteral(": ") + trial.error());
    return false;
  }

  /// Returns false where a file could not be written.
  bool simulate() {
    do {
      if (!m_tables.record(m_run)) return false;
      m_history.record(m_run);
    } while (m_run.time() < m_call.until && m_run.advance() == core::RunStatus::kRunning);
    return true;
  }

  ExitStatus showResult() const {
    if (!m_call.chart.isEmpty()) return writeChart();
    const bool wantsTables =
        !m_call.trajectory.isEmpty() || !m_call.energy.isEmpty() || !m_call.events.isEmpty();
    return wantsTables ? kSuccess : printed(m_history.table());
  }

  ExitStatus writeChart() const {
    const QString name = ui::runWords(m_call.solver);
    const QString error =
        ui::writeEnergyChart(m_call.chart, {{&m_history.ledger(), name}},
                             {QString::fromStdString(m_run.scene().name), QString()});
    if (error.isEmpty()) return kSuccess;
    return failure(kFailed, m_call.chart + QStringLiteral(": ") + error);
  }

  /// What to do about a run that diverged.
  QString advice() const {
    if (m_run.status() == core::RunStatus::kStalled)
      return Texts::tr("a larger --tolerance may help");
    if (m_run.method().isAdaptive) return Texts::tr("a smaller --tolerance may help");
    const std::optional<double> step =
        core::largestStableStep(m_scene, m_call.solver, m_call.until);
    if (!step) return Texts::tr("a smaller --step may help");
    return Texts::tr("--step %1 works").arg(QString::fromStdString(core::numberText(*step)));
  }

  /// Why the run could not go on.
  QString cause() const {
    if (m_run.status() == core::RunStatus::kDiverged)
      return Texts::tr("the numbers stopped being finite");
    if (m_run.status() == core::RunStatus::kEndless)
      return Texts::tr("the next step holds more events than can be followed");
    return Texts::tr("the tolerance asks for more or smaller steps than can be taken");
  }

  ExitStatus outcome() const {
    if (m_run.status() == core::RunStatus::kRunning) return kSuccess;
    const QString time = QString::fromStdString(core::numberText(m_run.time()));
    return failure(kDiverged, Texts::tr("diverged at %1 s: %2; %3").arg(time, cause(), advice()));
  }

  const SimulateCall& m_call;
  std::shared_ptr<const core::Scene> m_scene;
  core::Run m_run;
  RunTables m_tables;
  EnergyHistory m_history;
};

}  // namespace

ExitStatus runSimulate(const SimulateCall& call) {
  ui::SceneOrError read = ui::readFileOrBuiltIn(call.scene);
  if (!read.scene) return failure(kRefused, call.scene + QStringLiteral(": ") + read.error);
  if (call.cut) read.scene->cutTime = call.cut->time;
  return Simulation(call, std::make_shared<const core::Scene>(std::move(*read.scene))).run();
}

}  // namespace app
