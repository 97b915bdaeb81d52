#pragma once

#include "app/exit_status.h"
#include "app/options.h"

namespace app {

/// `angrycuts scenes`: prints name, tab and description of each built-in scene, or writes
/// them as files.
ExitStatus runScenes(const ScenesCall& call);

}  // namespace app
