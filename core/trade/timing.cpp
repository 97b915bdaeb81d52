#include "core/trade/timing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/run/run.h"
#include "core/system/cpu_clock.h"

namespace core {
namespace {

constexpr double kShortestTiming = 1e-3;  // [s]: a thousand times what the clock itself takes
constexpr int kMostRunsAtOnce = 100;
constexpr std::size_t kRepeats = 5;
constexpr double kMostTime = 0.3;            // [s] for all repeats; the first is always finished
constexpr int kWeightStepsUnasked = 50'000;  // between two questions whether to go on

/// Advances a run to its end, the time it is asked whether to go on not counted.
/// @return  computing time [s]; negative if it was stopped
double timeOf(Run& run, double until, WorkMeter& meter) {
  const int stepsUnasked = std::max(1, kWeightStepsUnasked / (1 + run.weightCount()));
  double total = 0;
  while (run.time() < until && run.status() == RunStatus::kRunning) {
    const double start = threadCpuTime();
    for (int i = 0; i < stepsUnasked && run.time() < until; ++i) {
      if (run.advance() != RunStatus::kRunning) break;
    }
    total += threadCpuTime() - start;
    if (!meter.add(0)) return -1;
  }
  return total;
}

/// Of several runs, one after the other [ns per simulated second].
double timeTogether(const std::shared_ptr<const Scene>& scene, const Solver& solver, double until,
                    int count, WorkMeter& meter) {
  std::vector<Run> runs;
  for (int i = 0; i < count; ++i) runs.emplace_back(scene, solver);
  double computed = 0, simulated = 0;
  for (Run& run : runs) {
    const double time = timeOf(run, until, meter);
    if (time < 0) return 0;
    computed += time;
    simulated += run.time();
  }
  return simulated > 0 ? 1e9 * computed / simulated : 0;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

double nanosecondsPerSimulatedSecond(const std::shared_ptr<const Scene>& scene,
                                     const Solver& solver, double until, double expected,
                                     WorkMeter& meter) {
  const double wanted = std::ceil(kShortestTiming / std::max(expected, 1e-9));
  const int count = static_cast<int>(std::clamp(wanted, 1.0, double{kMostRunsAtOnce}));
  std::vector<double> times;
  const double start = threadCpuTime();
  do {
    times.push_back(timeTogether(scene, solver, until, count, meter));
  } while (times.size() < kRepeats && threadCpuTime() - start < kMostTime && meter.add(0));
  return median(std::move(times));
}

}  // namespace core
