#include "core/system/cpu_clock.h"

#ifdef _WIN32
#include <windows.h>
#else
#include <ctime>
#endif

namespace core {

#ifdef _WIN32

double threadCpuTime() {
  const auto seconds = [](const FILETIME& time) {
    return 1e-7 * (4294967296.0 * time.dwHighDateTime + time.dwLowDateTime);
  };
  FILETIME created;
  FILETIME ended;
  FILETIME inSystem;
  FILETIME inProgram;
  GetThreadTimes(GetCurrentThread(), &created, &ended, &inSystem, &inProgram);
  return seconds(inSystem) + seconds(inProgram);
}

#else

double threadCpuTime() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

#endif

}  // namespace core
