// Whole runs of small scenes.

#include "core/scene/scene_limits.h"
#include "tests/fuzz/fuzzed_run.h"
#include "tests/fuzz/target.h"
#include "ui/files/scene_file.h"

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tests::endAt(tests::faultIn(tests::fuzzedRun(std::span(data, size))));
  return 0;
}

std::string tests::meaningOf(std::span<const std::uint8_t> bytes) {
  const FuzzedRun fuzzed = fuzzedRun(bytes);
  const core::Solver& solver = fuzzed.solver;
  const auto step = [](int number) { return number < 0 ? "never" : std::to_string(number); };
  return ui::sceneText(*fuzzed.scene).toStdString() + "by " + solver.method + " at " +
         core::numberText(solver.step) + " s, tolerance " + core::numberText(solver.tolerance) +
         (fuzzed.isOrdinary ? "; ordinary" : "; extreme") + "\nbefore step: all cut " +
         step(fuzzed.cutAllBefore) + ", the first cut " + step(fuzzed.cutOneBefore) +
         ", state taken " + step(fuzzed.resumedAt);
}
