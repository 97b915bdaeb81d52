#pragma once

#include "app/exit_status.h"
#include "app/options.h"

namespace app {

/// Whether there is a screen that somebody could see a window on.
bool hasDisplay();

/// Keeps a system without a session bus from being given one: where no bus is there, the library
/// that looks for one would start it, which is another program. Call before a QApplication exists.
void startNoBus();

/// In a line, why Qt could not open any window.
/// @param reason  Qt's own words
QString windowFailure(const QString& reason);

/// `angrycuts [SCENE]`: opens the window and stays until it is closed.
/// @pre hasDisplay(); a QApplication exists
ExitStatus runWindow(const WindowCall& call);

}  // namespace app
