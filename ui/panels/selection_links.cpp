#include "ui/panels/selection_links.h"

#include "ui/control/scene_editor.h"
#include "ui/control/selection.h"
#include "ui/panels/charts_panel.h"
#include "ui/panels/events_panel.h"
#include "ui/panels/step_panel.h"
#include "ui/panels/weights_form.h"

namespace ui {
namespace {

constexpr int kAll = -1;

/// What panels that show runs can show of the selection: a weight of a draft that cannot run
/// is in no run.
int inRuns(int selected, const SceneEditor& editor) {
  return selected < static_cast<int>(editor.scene()->weights.size()) ? selected : kAll;
}

/// @param weight  reads the index of what the panel shows; −1: all
/// @param choose  sets it
template <class Panel>
void follow(Selection* selection, const SceneEditor* editor, Panel* panel,
            int (Panel::*weight)() const, void (Panel::*choose)(int)) {
  QObject::connect(selection, &Selection::weightSelected, panel,
                   [=, before = kAll](int selected) mutable {
                     const int shown = inRuns(selected, *editor);
                     if (shown != kAll || (panel->*weight)() == before) (panel->*choose)(shown);
                     before = shown;
                   });
}

}  // namespace

void linkSelection(Selection* selection, const SceneEditor* editor, const WeightPanels& panels) {
  follow(selection, editor, panels.charts, &ChartsPanel::weight, &ChartsPanel::chooseWeight);
  follow(selection, editor, panels.events, &EventsPanel::weight, &EventsPanel::setWeight);
  // Both count from 1; 0 is all for the form, and leaves the step as it is.
  QObject::connect(selection, &Selection::weightSelected, panels.form,
                   [form = panels.form](int weight) { form->choose(weight + 1); });
  QObject::connect(selection, &Selection::weightSelected, panels.step,
                   [step = panels.step, editor](int weight) {
                     step->chooseWeight(inRuns(weight, *editor) + 1);
                   });
  const auto select = [selection](int number) { selection->select(number - 1); };
  QObject::connect(panels.form, &WeightsForm::weightChosen, selection, select);
  QObject::connect(panels.step, &StepPanel::weightChosen, selection, select);
}

}  // namespace ui
