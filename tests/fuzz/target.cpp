#include "tests/fuzz/target.h"

#include <cstdio>
#include <cstdlib>

namespace tests {

void endAt(const std::string& fault) {
  if (fault.empty()) return;
  std::fprintf(stderr, "fault: %s\n", fault.c_str());
  std::abort();
}

}  // namespace tests
