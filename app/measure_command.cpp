#include "app/measure_command.h"

#include <memory>
#include <utility>

#include <QCoreApplication>

#include "app/csv_output.h"
#include "app/measure_table.h"
#include "app/progress_line.h"
#include "core/trade/measurement.h"
#include "core/trade/measurement_csv.h"
#include "ui/chart/work_precision_export.h"
#include "ui/files/scene_file.h"

namespace app {
namespace {

core::Measurement measured(const std::shared_ptr<const core::Scene>& scene, double until) {
  ProgressLine line;
  return *core::measure(scene, core::measuredSolvers(), until, [&line](double share) {
    line.show(share);
    return true;
  });
}

ExitStatus chartFailure(const QString& file, const QString& error) {
  return failure(kFailed, file + QStringLiteral(": ") + error);
}

ExitStatus measureAndWrite(const MeasureCall& call,
                           const std::shared_ptr<const core::Scene>& scene) {
  // Whether files can be written is found out before the work, not after it.
  CsvOutput csv(call.csv, {});
  if (!csv.open()) return failure(kFailed, csv.error());
  ui::OutputFile trial;
  if (!call.chart.isEmpty() && !trial.open(call.chart)) {
    return chartFailure(call.chart, trial.error());
  }
  const auto measurement = std::make_shared<const core::Measurement>(measured(scene, call.until));
  csv.rows() = core::measurementCsv(*measurement);
  if (!csv.finish()) return failure(kFailed, csv.error());
  if (!call.chart.isEmpty()) {
    const QString error = ui::writeWorkPrecisionChart(
        call.chart, measurement, ui::ErrorAgainst::kCost, QString::fromStdString(scene->name));
    if (!error.isEmpty()) return chartFailure(call.chart, error);
  }
  const bool wantsTable = call.csv.isEmpty() && call.chart.isEmpty();
  return wantsTable ? printed(measureTable(*measurement)) : kSuccess;
}

}  // namespace

ExitStatus runMeasure(const MeasureCall& call) {
  ui::SceneOrError read = ui::readFileOrBuiltIn(call.scene);
  if (!read.scene) return failure(kRefused, call.scene + QStringLiteral(": ") + read.error);
  if (call.cut) read.scene->cutTime = call.cut->time;
  return measureAndWrite(call, std::make_shared<const core::Scene>(std::move(*read.scene)));
}

}  // namespace app
