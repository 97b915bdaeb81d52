#pragma once

namespace ui {

class ChartsPanel;
class EventsPanel;
class SceneEditor;
class Selection;
class StepPanel;
class WeightsForm;

/// The panels that show a weight of their own.
struct WeightPanels {
  WeightsForm* form;
  StepPanel* step;
  ChartsPanel* charts;
  EventsPanel* events;
};

/// Lets the panels follow the selection, and the form and the opened step select as well.
///
/// Charts and events show the weight that was selected last until another one is chosen in
/// them; when none is selected any more, those that still show it show all again.
void linkSelection(Selection* selection, const SceneEditor* editor, const WeightPanels& panels);

}  // namespace ui
