#include "tests/soak/process_figures.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <malloc.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

constexpr double kMiB = 1024.0 * 1024.0;

int entriesIn(const char* folder) {
  const std::filesystem::directory_iterator entries(folder);
  return static_cast<int>(std::distance(begin(entries), end(entries)));
}

double residentMiB() {
  long pages = 0;
  std::ifstream("/proc/self/statm") >> pages >> pages;  // the second number
  return static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE)) / kMiB;
}

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Looked up while the process lives: what the system tells afterwards counts the memory of this
/// process too, whose copy the other one is at its start. 0 once it has ended.
double peakMiBOf(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  std::string word;
  double kiB = 0;
  while (status >> word)
    if (word == "VmHWM:" && status >> kiB) break;
  return kiB / 1024;
}

/// What another process writes, piece by piece.
class Reader {
 public:
  Reader() {
    if (pipe2(m_ends.data(), O_CLOEXEC) != 0) std::abort();
  }
  ~Reader() { close(m_ends[0]); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// To write to; this process gives its own up with the first read.
  int end() const { return m_ends[1]; }

  /// 0 at the end.
  ssize_t read() {
    if (m_ends[1] >= 0) close(m_ends[1]);
    m_ends[1] = -1;
    return std::max<ssize_t>(::read(m_ends[0], m_bytes.data(), m_bytes.size()), 0);
  }
  std::int64_t linesIn(ssize_t count) const {
    return std::count(m_bytes.begin(), m_bytes.begin() + count, '\n');
  }

 private:
  std::array<int, 2> m_ends{-1, -1};
  std::vector<char> m_bytes = std::vector<char>(std::size_t{1} << 16);
};

pid_t started(const std::vector<std::string>& command, int output) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  pid_t process = -1;
  posix_spawn(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return process;
}

}  // namespace

ProcessFigures figuresNow() {
  const struct mallinfo2 heap = mallinfo2();
  return {.residentMiB = residentMiB(),
          .heapMiB = static_cast<double>(heap.uordblks + heap.hblkhd) / kMiB,
          .handles = entriesIn("/proc/self/fd") - 1,  // the one that looks
          .threads = entriesIn("/proc/self/task")};
}

Ended runToEnd(const std::vector<std::string>& command) {
  const double start = seconds();
  Reader reader;
  const pid_t process = started(command, reader.end());
  Ended ended;
  while (const ssize_t count = reader.read()) {
    ended.lines += reader.linesIn(count);
    ended.peakMiB = std::max(ended.peakMiB, peakMiBOf(process));
  }
  int status = 0;
  waitpid(process, &status, 0);
  if (WIFEXITED(status)) ended.status = WEXITSTATUS(status);
  ended.seconds = seconds() - start;
  return ended;
}
