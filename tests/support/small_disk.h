#pragma once

#include <csignal>
#include <sys/resource.h>

#include <QtGlobal>

/// While it lives no file can grow beyond a size, as on a disk that is full: the message is
/// "File too large" then. Holds for everybody, root included, and needs no disk of its own.
class SmallDisk {
 public:
  /// @param largestFile  [bytes]
  explicit SmallDisk(rlim_t largestFile) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &m_before);
    const struct rlimit small { largestFile, m_before.rlim_max };
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() { setrlimit(RLIMIT_FSIZE, &m_before); }
  Q_DISABLE_COPY_MOVE(SmallDisk)

 private:
  struct rlimit m_before {};
};
