#pragma once

#include "app/exit_status.h"
#include "app/options.h"

namespace app {

/// Whether there is a screen that somebody could see a window on.
bool hasDisplay();

/// `angrycuts [SCENE]`: opens the window and stays until it is closed.
/// @pre hasDisplay(); a QApplication exists
ExitStatus runWindow(const WindowCall& call);

}  // namespace app
