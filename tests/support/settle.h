#pragma once

#include <QCoreApplication>

namespace tests {

/// Lets a window do what it has put off: a layout may ask for another one.
inline void settle() {
  for (int round = 0; round < 5; ++round) QCoreApplication::processEvents();
}

}  // namespace tests
