#include "core/system/screen.h"

#include <cstdlib>
#include <initializer_list>

namespace core {

#if defined(_WIN32) || defined(__APPLE__)

bool hasScreen() {
  return true;
}

#else

bool hasScreen() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) {
    const char* value = std::getenv(name);
    if (value && *value != '\0') return true;
  }
  return false;
}

#endif

}  // namespace core
