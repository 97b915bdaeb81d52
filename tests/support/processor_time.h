#pragma once

#include <ctime>

namespace tests {

/// Processor time this program has used so far [s]: on a busy machine steadier than the clock
/// on the wall.
inline double processorTime() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace tests
