// Walks the corners of the ranges scene files allow, with every method and steps of 10⁻⁶, 1/60
// and 1 s: whatever happens there, numbers stay finite, weights in the room and apart, and it
// ends within a minute. Prints what does not hold; the test extremes_test walks a part of it.
//
//     corners_walk [STRIDE [STEPS [FIRST]]]      every corner; 20 steps of each; from 0
//
// Several share the walk, an hour or more of computing, with one stride and different firsts.

#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/methods/method.h"
#include "tests/support/corner_scene.h"

int main(int argc, char** argv) {
  const int stride = argc > 1 ? std::atoi(argv[1]) : 1;
  const int steps = argc > 2 ? std::atoi(argv[2]) : 20;
  const int first = argc > 3 ? std::atoi(argv[3]) : 0;
  if (stride < 1 || steps < 1 || first < 0) {
    std::fputs("corners_walk [STRIDE [STEPS [FIRST]]]\n", stderr);
    return 2;
  }
  int runs = 0, faults = 0;
  for (int corner = first; corner < 1 << tests::kCornerChoices; corner += stride)
    for (const core::Method& method : core::methods())
      for (const double step : {1e-6, 1.0 / 60, 1.0}) {
        const core::Solver solver{std::string(method.id), step, 1e-6};
        const std::string fault = tests::faultAtCorner(corner, solver, steps);
        ++runs;
        if (fault.empty()) continue;
        ++faults;
        std::printf("corner %d, %s at %g s: %s\n", corner, solver.method.c_str(), step,
                    fault.c_str());
        std::fflush(stdout);
      }
  std::printf("%d runs, %d faults\n", runs, faults);
  return faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
