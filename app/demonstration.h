#pragma once

#include <QString>

#include "app/exit_status.h"

namespace app {

/// What stands in for the window where there is no display: simulates the scene with its
/// methods side by side and writes, into the current folder, their energy chart, the first
/// one's trajectory and a picture of the scene in flight; prints what each file shows.
///
/// @param scene  a file or the name of a built-in scene
/// @pre a QGuiApplication exists; it needs no display
ExitStatus runDemonstration(const QString& scene);

}  // namespace app
