// Linked into every test program of a build with sanitizers.

#include <dlfcn.h>

extern "C" {

/// Keeps plugins loaded, or the leak report could not say where a leak came from and the
/// suppressions below would not match.
int dlclose(void* /*library*/) noexcept {
  return 0;
}

/// Leaks that are not ours, one a line.
const char* __lsan_default_suppressions();
const char* __lsan_default_suppressions() {
  return "leak:libdbus-1.so\n";
}
}
