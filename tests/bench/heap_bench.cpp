// Heaps too large for the tests: pours weights into a narrow room, prints what became of them
// after 60 s, and fails where a bound is broken.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "tests/support/heap.h"
#include "tests/support/processor_time.h"

namespace {

constexpr double kDuration = 60;  // [s]

struct Bounds {
  double overlap;  // [m]
  double time;     // of computing [s]
};

Bounds boundsFor(int count) {
  if (count > 200) return {1e-5, 600};
  return {1e-6, 10};
}

bool runRow(int count, double restitution) {
  const double start = tests::processorTime();
  const tests::HeapFigures heap =
      tests::runHeap(tests::pouredHeap(count, restitution), {}, kDuration);
  const double time = tests::processorTime() - start;
  const Bounds bounds = boundsFor(count);
  const bool holds = heap.finished && heap.overlap <= bounds.overlap && heap.kinetic <= 1e-6 &&
                     heap.highestEnergy <= 1 + 1e-12 && std::abs(heap.drift) <= 0.01 &&
                     time <= bounds.time;
  std::printf("%7d  %4.2f  %10.2g  %10.2g  %13.6f  %+8.3f  %11zu  %7.2f  %s\n", count, restitution,
              heap.overlap, heap.kinetic, heap.highestEnergy, 100 * heap.drift, heap.mostEvents,
              time, holds ? "ok" : "BROKEN");
  std::fflush(stdout);
  return holds;
}

}  // namespace

/// @param arguments  counts of weights; 7, 50, 200 and 1000 if there are none
int main(int count, char** arguments) {
  std::vector<int> counts;
  for (int i = 1; i < count; ++i) counts.push_back(std::atoi(arguments[i]));
  if (counts.empty()) counts = {7, 50, 200, 1000};
  std::printf(
      "weights     e  overlap, m  kinetic, J  highest/start   drift, %%  events/step   CPU, s\n");
  bool allHold = true;
  for (const int weights : counts)
    for (const double restitution : {0.5, 0.8}) allHold = runRow(weights, restitution) && allHold;
  return allHold ? EXIT_SUCCESS : EXIT_FAILURE;
}
