#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <optional>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "tests/bench/peers/rounds.h"
#include "tests/bench/peers/rows.h"
#include "tests/bench/peers/table.h"

namespace bench {
namespace {

struct ProgramTimes {
  double firstByte = 0;  // from its start to its first output, on the clock [s]
  double processor = 0;  // used until its end [s]
};

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Reads all a program says.
/// @return  when the first of it came
std::chrono::steady_clock::time_point drained(int from) {
  char buffer[65536];
  std::optional<std::chrono::steady_clock::time_point> first;
  while (read(from, buffer, sizeof buffer) > 0)
    if (!first) first = std::chrono::steady_clock::now();
  return first.value_or(std::chrono::steady_clock::now());
}

/// @return  nothing if it fails
std::optional<ProgramTimes> timesOf(std::vector<const char*> call) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return {};
  call.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  const auto start = std::chrono::steady_clock::now();
  pid_t child = 0;
  const int failed = posix_spawn(&child, call[0], &actions, nullptr,
                                 const_cast<char* const*>(call.data()), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  const auto first = failed ? start : drained(ends[0]);
  close(ends[0]);
  int status = 0;
  rusage usage{};
  if (failed || wait4(child, &status, 0, &usage) != child || status != 0) return {};
  return ProgramTimes{std::chrono::duration<double>(first - start).count(),
                      seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

/// Medians of several calls.
std::optional<ProgramTimes> typicalTimesOf(const std::vector<const char*>& call) {
  std::vector<double> first, processor;
  for (int i = 0; i < 7; ++i) {
    const auto times = timesOf(call);
    if (!times) return {};
    first.push_back(times->firstByte);
    processor.push_back(times->processor);
  }
  return ProgramTimes{median(first), median(processor)};
}

}  // namespace

void printStartRows() {
  setenv("QT_QPA_PLATFORM", "offscreen", 1);
  const auto simulated = typicalTimesOf(
      {BENCH_PROGRAM, "simulate", "seven-weights", "--until", "10", "--trajectory", "-"});
  const auto window = typicalTimesOf({BENCH_WINDOW, "first-frame"});
  const std::string failed = "failed";
  print({.work = "`simulate`: start to first row, on the clock",
         .ours = simulated ? duration(simulated->firstByte) : failed,
         .aim = "stated"});
  print({.work = "`simulate seven-weights` for 10 s: processor time, start included",
         .ours = simulated ? duration(simulated->processor) : failed,
         .aim = "≤ 50 ms",
         .isReached = simulated && simulated->processor <= 0.05});
  print({.work = "window, offscreen: start to first frame, on the clock; processor time",
         .ours = window ? duration(window->firstByte) + "; " + duration(window->processor) : failed,
         .aim = "stated"});
}

}  // namespace bench
