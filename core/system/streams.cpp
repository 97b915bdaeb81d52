#include "core/system/streams.h"

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#else
#include <csignal>
#include <unistd.h>
#endif

namespace core {

#ifdef _WIN32

bool isTerminal(std::FILE* stream) {
  return _isatty(_fileno(stream)) != 0;
}

int descriptorOf(std::FILE* stream) {
  _setmode(_fileno(stream), _O_BINARY);
  return _fileno(stream);
}

void outliveClosedPipes() {}

#else

bool isTerminal(std::FILE* stream) {
  return isatty(fileno(stream)) != 0;
}

int descriptorOf(std::FILE* stream) {
  return fileno(stream);
}

void outliveClosedPipes() {
  std::signal(SIGPIPE, SIG_IGN);
}

#endif

}  // namespace core
