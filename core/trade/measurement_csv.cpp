#include "core/trade/measurement_csv.h"

#include "core/recording/csv_row.h"
#include "core/scene/scene_limits.h"

namespace core {
namespace {

std::string outcomeOf(const MeasuredPoint& point) {
  return point.isComplete() ? "ok" : "diverged at " + numberText(point.reached);
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
