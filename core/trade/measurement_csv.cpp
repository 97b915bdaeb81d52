#include "core/trade/measurement_csv.h"

#include "core/recording/csv_row.h"
#include "core/scene/scene_limits.h"

namespace core {
namespace {

std::string outcomeOf(const MeasuredPoint& point) {
  switch (point.status) {
    case RunStatus::kRunning:
      break;
    case RunStatus::kDiverged:
      return "diverged at " + numberText(point.reached);
    case RunStatus::kEndless:
    case RunStatus::kStalled:
      return "stopped at " + numberText(point.reached);
  }
  return "ok";
}

}  // namespace

std::string measurementCsv(const Measurement& measurement) {
  std::string csv =
      "method,setting,steps,evaluations,max_position_error,max_energy_drift,"
      "nanoseconds_per_simulated_second,outcome\r\n";
  for (const MethodCurve& curve : measurement.curves) {
    for (const MeasuredPoint& point : curve.points) {
      CsvRow(csv) << curve.method->id << settingOf(point.solver) << point.steps << point.evaluations
                  << point.maxPositionError << point.maxEnergyDrift
                  << point.nanosecondsPerSimulatedSecond << outcomeOf(point);
    }
  }
  return csv;
}

}  // namespace core
