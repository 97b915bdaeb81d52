#pragma once

#include "core/scene/scene.h"

namespace ui {

class SceneEditor;

/// Lets the scene run with that solver as well: beside the others, or in place of the last one
/// if no more can stand side by side. One that runs already stays as it is.
/// @return  index of the run that has the solver
int openAsRun(SceneEditor& editor, const core::Solver& solver);

}  // namespace ui
