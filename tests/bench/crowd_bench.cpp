// Crowds of discs in a box at packing 0.3, under gravity, e = 0.8: milliseconds of computing
// per step of 1/60 s, over the first second and over all seconds asked for. More than 100 come
// twice: in a box as high as it is wide, and in one as high as that of 100.
//
//     crowd_bench [SECONDS] [WEIGHTS …]          10 s; 10, 100, 1,000 and 10,000 weights

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "core/run/run.h"
#include "tests/support/crowd.h"
#include "tests/support/heap.h"
#include "tests/support/processor_time.h"

using core::Run;
using core::RunStatus;

namespace {

constexpr double kStep = 1.0 / 60;
constexpr int kRows = 10;  // of a hundred

/// What a run did up to some time.
struct Progress {
  double computing = 0;  // [s]
  double overlap = 0;    // largest after any step [m]
};

/// Takes whole steps up to that time; looking for overlaps is not counted as computing.
/// @return  false if the run ended before
bool runUntil(Run& run, double time, Progress& progress) {
  while (run.time() < time - kStep / 2) {
    const double start = tests::processorTime();
    const RunStatus status = run.advance();
    progress.computing += tests::processorTime() - start;
    if (status != RunStatus::kRunning) return false;
    progress.overlap = std::max(progress.overlap, tests::largestOverlap(run));
  }
  return true;
}

bool report(const core::Scene& crowd, double seconds) {
  Run run(std::make_shared<const core::Scene>(crowd), {.method = "rk4", .step = kStep});
  Progress progress;
  const bool begun = runUntil(run, 1, progress);
  const double inFirst = progress.computing;
  const bool done = begun && runUntil(run, seconds, progress);
  std::printf("%8d %6.1f x %4.1f %14.4f %14.4f %10.1e %10s\n", run.weightCount(), crowd.room.width,
              crowd.room.height, inFirst * 1e3 * kStep, progress.computing * 1e3 * kStep / seconds,
              progress.overlap, done ? "ok" : "ended early");
  std::fflush(stdout);
  return done;
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 10;
  std::vector<int> counts;
  for (int i = 2; i < argc; ++i) counts.push_back(std::atoi(argv[i]));
  if (counts.empty()) counts = {10, 100, 1000, 10000};
  std::printf("%8s %13s %14s %14s %10s\n", "weights", "box [m]", "first s [ms]", "all [ms]",
              "overlap");
  bool all = true;
  for (const int count : counts) {
    all = report(tests::crowd(count), seconds) && all;
    if (count > kRows * kRows) all = report(tests::crowd(count, count / kRows), seconds) && all;
  }
  return all ? EXIT_SUCCESS : EXIT_FAILURE;
}
