#pragma once

#include <QString>

namespace app {

/// What the program's end tells the caller.
enum ExitStatus {
  kSuccess = 0,
  kFailed = 1,    ///< anything but the next two, such as a full disk
  kRefused = 2,   ///< the call or the scene
  kDiverged = 3,  ///< the numbers, or the events of a step, got out of hand
};

/// Writes one line to standard error, "angrycuts: " before it.
/// @return  the status itself
ExitStatus failure(ExitStatus status, const QString& line);

/// Writes to standard output; where that fails, says why.
ExitStatus printed(const QString& text);

}  // namespace app
