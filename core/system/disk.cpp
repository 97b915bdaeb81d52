#include "core/system/disk.h"

#ifndef _WIN32
#include <fcntl.h>
#include <unistd.h>
#endif

namespace core {

#ifdef _WIN32

void syncFolder(const std::string& /*folder*/) {}

#else

void syncFolder(const std::string& folder) {
  const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle < 0) return;
  ::fsync(handle);
  ::close(handle);
}

#endif

}  // namespace core
