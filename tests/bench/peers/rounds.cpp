#include "tests/bench/peers/rounds.h"

#include <algorithm>
#include <benchmark/benchmark.h>

#include "tests/support/processor_time.h"

namespace bench {
namespace {

/// Hears from Google Benchmark and prints nothing.
class Collector : public benchmark::BenchmarkReporter {
 public:
  std::vector<double> times;  // [s]

  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      times.push_back(run.cpu_accumulated_time / static_cast<double>(run.iterations));
  }
};

/// @param times  round by round, all contenders in each
std::vector<Timing> mediansOf(const std::vector<double>& times, std::size_t contenders) {
  std::vector<Timing> timings;
  for (std::size_t who = 0; who < contenders; ++who) {
    std::vector<double> own, ratios;
    for (std::size_t round = 0; round + contenders <= times.size(); round += contenders) {
      own.push_back(times[round + who]);
      ratios.push_back(times[round + who] / times[round]);
    }
    timings.push_back({median(own), median(ratios)});
  }
  return timings;
}

}  // namespace

std::vector<Timing> timed(const std::vector<Contender>& contenders, int rounds) {
  constexpr double kLeastTime = 0.02;  // [s]
  benchmark::ClearRegisteredBenchmarks();
  for (const Contender& contender : contenders)
    benchmark::RegisterBenchmark(contender.name.c_str(), [&contender](benchmark::State& state) {
      while (state.KeepRunning()) contender.work();
    })->MinTime(kLeastTime);
  Collector collector;
  for (int round = 0; round < rounds; ++round) benchmark::RunSpecifiedBenchmarks(&collector, ".");
  return mediansOf(collector.times, contenders.size());
}

std::vector<Timing> timedOnce(const std::vector<Contender>& contenders, int rounds) {
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round)
    for (const Contender& contender : contenders) {
      const double start = tests::processorTime();
      contender.work();
      times.push_back(tests::processorTime() - start);
    }
  return mediansOf(times, contenders.size());
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace bench
