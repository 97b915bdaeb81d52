#pragma once

#include "app/exit_status.h"
#include "app/options.h"

namespace app {

/// `angrycuts simulate SCENE`: runs a scene without a window and writes what was asked for.
ExitStatus runSimulate(const SimulateCall& call);

}  // namespace app
