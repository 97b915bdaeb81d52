#include "ui/control/open_as_run.h"

#include <algorithm>

#include <QCoreApplication>

#include "core/methods/method.h"
#include "core/scene/scene_limits.h"
#include "core/trade/settings.h"
#include "ui/control/scene_editor.h"

namespace ui {

int openAsRun(SceneEditor& editor, const core::Solver& solver) {
  const auto isSame = [&](const core::Solver& other) {
    return other.method == solver.method && core::settingOf(other) == core::settingOf(solver);
  };
  const std::vector<core::Solver>& running = editor.draft().solvers;
  const auto found = std::ranges::find_if(running, isSame);
  if (found != running.end()) return static_cast<int>(found - running.begin());
  const auto edit = [&](core::Scene& draft) {
    if (draft.solvers.size() == static_cast<std::size_t>(core::kMostSolvers)) {
      draft.solvers.pop_back();
    }
    draft.solvers.push_back(solver);
    // Measured with a long one; on screen its steps are what is shown one by one.
    if (core::findMethod(solver.method)->isAdaptive) {
      draft.solvers.back().step = core::Solver().step;
    }
  };
  editor.change(edit,
                [] { return QCoreApplication::translate("ui::OpenAsRun", "addition of a run"); });
  return static_cast<int>(editor.draft().solvers.size()) - 1;
}

}  // namespace ui
