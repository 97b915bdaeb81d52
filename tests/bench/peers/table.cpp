#include "tests/bench/peers/table.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <ctime>
#include <fstream>

namespace bench {
namespace {

std::string processorName() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char date[16];
  std::strftime(date, sizeof date, "%Y-%m-%d", std::gmtime(&now));
  return date;
}

/// How many processes waited for a processor on average over the last minute.
std::string load() {
  std::ifstream info("/proc/loadavg");
  std::string first = "?";
  info >> first;
  return first;
}

}  // namespace

void printHeading() {
  std::printf("%s, load %s at the start; %s; %s; processor time, medians of rounds in turn\n\n",
              processorName().c_str(), load().c_str(), today().c_str(), BENCH_COMPILER);
  std::puts("| work | Angry Cuts | best of the others | ratio | aim | reached |");
  std::puts("| --- | --- | --- | --- | --- | --- |");
  std::fflush(stdout);
}

void print(const Row& row) {
  std::printf("| %s | %s | %s | %s | %s | %s |\n", row.work.c_str(), row.ours.c_str(),
              row.peer.empty() ? "–" : row.peer.c_str(),
              row.ratio.empty() ? "–" : row.ratio.c_str(), row.aim.c_str(),
              row.aim == "stated" ? "–" : (row.isReached ? "yes" : "no"));
  std::fflush(stdout);
}

void printMissing() {
  if (*BENCH_MISSING != 0)
    std::printf("\nLeft out when this was built, as packages were missing:%s\n", BENCH_MISSING);
}

std::string text(const char* format, ...) {
  char buffer[512];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return buffer;
}

std::string duration(double seconds) {
  if (seconds < 1e-10) return text("%.1e s", seconds);
  if (seconds < 1e-6) return text("%.3g ns", seconds * 1e9);
  if (seconds < 1e-3) return text("%.3g µs", seconds * 1e6);
  if (seconds < 1) return text("%.3g ms", seconds * 1e3);
  return text("%.3g s", seconds);
}

std::string times(double ratio) {
  if (ratio < 1e4) return text(ratio < 10 ? "%.2g×" : "%.0f×", ratio);
  return text("10^%.0f×", std::floor(std::log10(ratio)));
}

}  // namespace bench
