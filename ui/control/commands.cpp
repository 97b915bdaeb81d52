#include "ui/control/commands.h"

#include <QAction>
#include <QKeySequence>

#include "ui/style/icons.h"

namespace ui {
namespace {

/// How a command looks: `text` stands in menus, `shortText` on buttons.
struct Look {
  Command command;
  const char* text;
  const char* shortText;
  const char* tip;
  const char* icon;
  const char* keys;
  bool isToggle = false;  ///< on or off
};

constexpr bool kToggle = true;

constexpr Look kLooks[] = {
    {Command::kNew, QT_TRANSLATE_NOOP("ui::Commands", "&New"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Start with one weight in an empty room"), "new", "Ctrl+N"},
    {Command::kOpen, QT_TRANSLATE_NOOP("ui::Commands", "&Open…"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Open a scene file"), "open", "Ctrl+O"},
    {Command::kLessons, QT_TRANSLATE_NOOP("ui::Commands", "&Lessons…"),
     QT_TRANSLATE_NOOP("ui::Commands", "Lessons"),
     QT_TRANSLATE_NOOP("ui::Commands", "Choose one of the built-in scenes by its picture"),
     "lessons", "Ctrl+L"},
    {Command::kSave, QT_TRANSLATE_NOOP("ui::Commands", "&Save"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Save the scene"), "save", "Ctrl+S"},
    {Command::kSaveAs, QT_TRANSLATE_NOOP("ui::Commands", "Save &as…"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Save the scene in another file"), "", "Ctrl+Shift+S"},
    {Command::kExportChart, QT_TRANSLATE_NOOP("ui::Commands", "&Export chart…"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Save the chart as a PNG, SVG or PDF picture"), "chart",
     "Ctrl+E"},
    {Command::kExportPicture, QT_TRANSLATE_NOOP("ui::Commands", "Export &picture of the scene…"),
     "", QT_TRANSLATE_NOOP("ui::Commands", "Save what is shown as a PNG, SVG or PDF picture"),
     "picture", "Ctrl+Shift+E"},
    {Command::kQuit, QT_TRANSLATE_NOOP("ui::Commands", "&Quit"), "", "", "quit", "Ctrl+Q"},
    {Command::kUndo, QT_TRANSLATE_NOOP("ui::Commands", "&Undo"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Take back the last change of the scene"), "undo", "Ctrl+Z"},
    {Command::kRedo, QT_TRANSLATE_NOOP("ui::Commands", "&Redo"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Make the change again that was taken back last"), "redo",
     "Ctrl+Shift+Z"},
    {Command::kWeightsTable, QT_TRANSLATE_NOOP("ui::Commands", "&Weights table"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "All weights in a table, to be changed many at once"),
     "table", "Ctrl+T"},
    {Command::kPlay, QT_TRANSLATE_NOOP("ui::Commands", "&Play"),
     QT_TRANSLATE_NOOP("ui::Commands", "Play"),
     QT_TRANSLATE_NOOP("ui::Commands", "Let time pass, or stop it"), "play", "Space"},
    {Command::kStep, QT_TRANSLATE_NOOP("ui::Commands", "&Step"),
     QT_TRANSLATE_NOOP("ui::Commands", "Step"),
     QT_TRANSLATE_NOOP("ui::Commands", "Take one integration step of the first run"), "step",
     "Right"},
    {Command::kStepBack, QT_TRANSLATE_NOOP("ui::Commands", "Step &back"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Go back by one integration step of the first run"),
     "step-back", "Left"},
    {Command::kStepFrame, QT_TRANSLATE_NOOP("ui::Commands", "Step one &frame"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Go on by 1/60 s, times the speed"), "step-frame",
     "Shift+Right"},
    {Command::kStepFrameBack, QT_TRANSLATE_NOOP("ui::Commands", "Step a f&rame back"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Go back by 1/60 s, times the speed"), "step-frame-back",
     "Shift+Left"},
    {Command::kCut, QT_TRANSLATE_NOOP("ui::Commands", "&Cut the ropes"),
     QT_TRANSLATE_NOOP("ui::Commands", "Cut"),
     QT_TRANSLATE_NOOP("ui::Commands", "Cut all ropes now"), "cut", "C"},
    {Command::kReset, QT_TRANSLATE_NOOP("ui::Commands", "&Reset"),
     QT_TRANSLATE_NOOP("ui::Commands", "Reset"),
     QT_TRANSLATE_NOOP("ui::Commands", "Go back to the start"), "reset", "R"},
    {Command::kSlower, QT_TRANSLATE_NOOP("ui::Commands", "S&lower"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Halve the speed"), "slower", ","},
    {Command::kFaster, QT_TRANSLATE_NOOP("ui::Commands", "F&aster"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Double the speed"), "faster", "."},
    {Command::kSplit, QT_TRANSLATE_NOOP("ui::Commands", "Split &views"),
     QT_TRANSLATE_NOOP("ui::Commands", "Split"),
     QT_TRANSLATE_NOOP("ui::Commands", "Give each run a view of its own"), "split", "V", kToggle},
    {Command::kNextEvent, QT_TRANSLATE_NOOP("ui::Commands", "&Next event"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Go to the next event of any kind"), "next-event",
     "Ctrl+Right"},
    {Command::kPreviousEvent, QT_TRANSLATE_NOOP("ui::Commands", "&Previous event"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Go back to the event before"), "previous-event",
     "Ctrl+Left"},
    {Command::kNextImpact, QT_TRANSLATE_NOOP("ui::Commands", "Next &impact"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Go on until something is hit"), "", "I"},
    {Command::kPreviousImpact, QT_TRANSLATE_NOOP("ui::Commands", "Previous i&mpact"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Go back to the impact before"), "", "Shift+I"},
    {Command::kNextTurningPoint, QT_TRANSLATE_NOOP("ui::Commands", "Next &turning point"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Go on until a weight turns round on its rope"), "", "U"},
    {Command::kPreviousTurningPoint, QT_TRANSLATE_NOOP("ui::Commands", "Previous t&urning point"),
     "", QT_TRANSLATE_NOOP("ui::Commands", "Go back to the turning point before"), "", "Shift+U"},
    {Command::kNextCut, QT_TRANSLATE_NOOP("ui::Commands", "Next &cut"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Go on until ropes are cut"), "", "X"},
    {Command::kPreviousCut, QT_TRANSLATE_NOOP("ui::Commands", "Previous cu&t"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Go back to the cut before"), "", "Shift+X"},
    {Command::kGoToStart, QT_TRANSLATE_NOOP("ui::Commands", "&Start of the recording"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Show the start again; what is recorded stays"),
     "go-to-start", "Home"},
    {Command::kGoToEnd, QT_TRANSLATE_NOOP("ui::Commands", "&End of the recording"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Show the last moment that is computed"), "go-to-end",
     "End"},
    {Command::kGoTo, QT_TRANSLATE_NOOP("ui::Commands", "&Go to a time…"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Show any moment, and compute it first where needed"), "",
     "Ctrl+G"},
    {Command::kStopTravelling, QT_TRANSLATE_NOOP("ui::Commands", "Stop &on the way"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Stay at the moment that the computing has come to"), "",
     "Escape"},
    {Command::kMeasure, QT_TRANSLATE_NOOP("ui::Commands", "Speed and &accuracy…"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Measure what accuracy costs, and how large steps may be"),
     "accuracy", "Ctrl+M"},
    {Command::kWhenToCut, QT_TRANSLATE_NOOP("ui::Commands", "&When to cut?…"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Find the moments to cut at that hit the target"),
     "when-to-cut", "W"},
    {Command::kTrails, QT_TRANSLATE_NOOP("ui::Commands", "&Trails"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Show where the weights have just been"), "trails", "T",
     kToggle},
    {Command::kVelocities, QT_TRANSLATE_NOOP("ui::Commands", "V&elocities"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Show how fast the weights move, and where to, as arrows"),
     "velocities", "Shift+V", kToggle},
    {Command::kForces, QT_TRANSLATE_NOOP("ui::Commands", "Fo&rces"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Show gravity, air drag and the pull of the rope as arrows"),
     "forces", "Shift+F", kToggle},
    {Command::kTensions, QT_TRANSLATE_NOOP("ui::Commands", "Te&nsions"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Show in newtons how hard each rope pulls"), "tensions",
     "Shift+T", kToggle},
    {Command::kTape, QT_TRANSLATE_NOOP("ui::Commands", "&Ruler"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Measure a length in the scene"), "tape", "D", kToggle},
    {Command::kProtractor, QT_TRANSLATE_NOOP("ui::Commands", "&Protractor"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Measure an angle in the scene"), "protractor", "A",
     kToggle},
    {Command::kStopwatch, QT_TRANSLATE_NOOP("ui::Commands", "&Stopwatch"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Measure simulated time"), "stopwatch", "K", kToggle},
    {Command::kStartStopwatch, QT_TRANSLATE_NOOP("ui::Commands", "S&tart or stop the stopwatch"),
     "", QT_TRANSLATE_NOOP("ui::Commands", "Start the stopwatch at the moment shown, or stop it"),
     "", "S"},
    {Command::kZeroStopwatch, QT_TRANSLATE_NOOP("ui::Commands", "Stopwatch to &zero"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Set the stopwatch back to zero"), "", "Shift+S"},
    {Command::kNextToolPart, QT_TRANSLATE_NOOP("ui::Commands", "&Next handle"), "",
     QT_TRANSLATE_NOOP("ui::Commands",
                       "Choose what Alt and the arrow keys move: an end of the ruler, an arm of "
                       "the protractor …"),
     "", "H"},
    {Command::kTarget, QT_TRANSLATE_NOOP("ui::Commands", "Tar&get"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Show a target on the floor; drag it to where it shall be"),
     "target", "G", kToggle},
    {Command::kLessonText, QT_TRANSLATE_NOOP("ui::Commands", "&Lesson text"),
     QT_TRANSLATE_NOOP("ui::Commands", "Lesson"),
     QT_TRANSLATE_NOOP("ui::Commands", "Show what to look for and what to try, or hide it"),
     "lesson", "L", kToggle},
    {Command::kFit, QT_TRANSLATE_NOOP("ui::Commands", "&Fit the room"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Show the whole room"), "fit", "F"},
    {Command::kZoomIn, QT_TRANSLATE_NOOP("ui::Commands", "Zoom &in"), "", "", "zoom-in", "Ctrl++"},
    {Command::kZoomOut, QT_TRANSLATE_NOOP("ui::Commands", "Zoom &out"), "", "", "zoom-out",
     "Ctrl+-"},
    {Command::kNextWeight, QT_TRANSLATE_NOOP("ui::Commands", "&Next weight"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Select the next weight"), "", "N"},
    {Command::kPreviousWeight, QT_TRANSLATE_NOOP("ui::Commands", "&Previous weight"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Select the weight before"), "", "Shift+N"},
    {Command::kDeselect, QT_TRANSLATE_NOOP("ui::Commands", "Select n&one"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Select no weight and no handle any more"), "", "Escape"},
    {Command::kMoveLeft, QT_TRANSLATE_NOOP("ui::Commands", "Move &left"), "",
     QT_TRANSLATE_NOOP(
         "ui::Commands",
         "Turn the rope of the selected weight to the left, or move the weight or handle"),
     "", "Alt+Left"},
    {Command::kMoveRight, QT_TRANSLATE_NOOP("ui::Commands", "Move &right"), "",
     QT_TRANSLATE_NOOP(
         "ui::Commands",
         "Turn the rope of the selected weight to the right, or move the weight or handle"),
     "", "Alt+Right"},
    {Command::kMoveUp, QT_TRANSLATE_NOOP("ui::Commands", "Move &up"), "",
     QT_TRANSLATE_NOOP("ui::Commands",
                       "Shorten the rope of the selected weight, or move the weight or handle up"),
     "", "Alt+Up"},
    {Command::kMoveDown, QT_TRANSLATE_NOOP("ui::Commands", "Move &down"), "",
     QT_TRANSLATE_NOOP(
         "ui::Commands",
         "Lengthen the rope of the selected weight, or move the weight or handle down"),
     "", "Alt+Down"},
    {Command::kAccelerateLeft, QT_TRANSLATE_NOOP("ui::Commands", "Faster l&eft"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Add to the speed of the selected weight towards the left"),
     "", "Alt+Shift+Left"},
    {Command::kAccelerateRight, QT_TRANSLATE_NOOP("ui::Commands", "Faster r&ight"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Add to the speed of the selected weight towards the right"),
     "", "Alt+Shift+Right"},
    {Command::kAccelerateUp, QT_TRANSLATE_NOOP("ui::Commands", "&Faster up"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Add to the speed of the selected weight upwards"), "",
     "Alt+Shift+Up"},
    {Command::kAccelerateDown, QT_TRANSLATE_NOOP("ui::Commands", "Fa&ster down"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Add to the speed of the selected weight downwards"), "",
     "Alt+Shift+Down"},
    {Command::kPresent, QT_TRANSLATE_NOOP("ui::Commands", "&Present"),
     QT_TRANSLATE_NOOP("ui::Commands", "Present"),
     QT_TRANSLATE_NOOP("ui::Commands",
                       "Fill the screen with the scene and one chart, in large type"),
     "present", "F11", kToggle},
    {Command::kNextChart, QT_TRANSLATE_NOOP("ui::Commands", "&Next chart"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Show the next kind of chart"), "next-chart", "Ctrl+PgDown"},
    {Command::kPreviousChart, QT_TRANSLATE_NOOP("ui::Commands", "&Previous chart"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Show the previous kind of chart"), "previous-chart",
     "Ctrl+PgUp"},
    {Command::kChartReset, QT_TRANSLATE_NOOP("ui::Commands", "&Whole chart"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Show all of the chart again after zooming"), "fit",
     "Ctrl+0"},
    {Command::kCopyChart, QT_TRANSLATE_NOOP("ui::Commands", "&Copy chart"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Copy the chart as a picture for paper"), "picture",
     "Ctrl+Shift+C"},
    {Command::kCopyChartData, QT_TRANSLATE_NOOP("ui::Commands", "Copy chart &data"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Copy the chart's curves as a table for a spreadsheet"),
     "table", "Ctrl+Shift+D"},
    {Command::kSheet, QT_TRANSLATE_NOOP("ui::Commands", "&Teacher's sheet"),
     QT_TRANSLATE_NOOP("ui::Commands", "Sheet"),
     QT_TRANSLATE_NOOP("ui::Commands",
                       "Goal, steps, questions and expected figures of this lesson, to be printed"),
     "sheet", "Shift+L"},
    {Command::kGuide, QT_TRANSLATE_NOOP("ui::Commands", "Quick &guide"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Explain the window in a few pages"), "guide", "Shift+F1"},
    {Command::kModel, QT_TRANSLATE_NOOP("ui::Commands", "The &model"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Show the equations that are computed, and why"), "model",
     "M"},
    {Command::kTour, QT_TRANSLATE_NOOP("ui::Commands", "T&our of the window"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "Point out the five most important parts of the window"),
     "tour", "Ctrl+Shift+F1"},
    {Command::kKeys, QT_TRANSLATE_NOOP("ui::Commands", "&Keys"), "",
     QT_TRANSLATE_NOOP("ui::Commands", "List all keys"), "keys", "F1"},
    {Command::kAbout, QT_TRANSLATE_NOOP("ui::Commands", "&About Angry Cuts"), "", "", "", ""},
};

}  // namespace

Commands::Commands(QObject* parent) : QObject(parent) {
  for (const Look& look : kLooks) {
    auto* action = new QAction(tr(look.text), this);
    const bool hasShortText = *look.shortText != '\0';
    if (hasShortText) action->setIconText(tr(look.shortText));
    if (*look.icon != '\0') action->setIcon(icon(look.icon));
    action->setShortcut(QKeySequence(look.keys));
    action->setCheckable(look.isToggle);
    if (*look.tip != '\0') {
      action->setStatusTip(tr(look.tip));
      const QString keys = action->shortcut().toString(QKeySequence::NativeText);
      action->setToolTip(tr("%1 (%2)").arg(tr(look.tip), keys));
    }
    m_actions[look.command] = action;
  }
  action(Command::kTrails)->setChecked(true);
  action(Command::kZoomIn)->setShortcuts({QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")});
  action(Command::kRedo)->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  action(Command::kQuit)->setMenuRole(QAction::QuitRole);
  action(Command::kAbout)->setMenuRole(QAction::AboutRole);
}

std::vector<QAction*> Commands::all() const {
  std::vector<QAction*> actions;
  for (const auto& [command, action] : m_actions) actions.push_back(action);
  return actions;
}

void Commands::showPlaying(bool playing) const {
  QAction* play = action(Command::kPlay);
  play->setText(playing ? tr("&Pause") : tr("&Play"));
  play->setIconText(playing ? tr("Pause") : tr("Play"));
  play->setIcon(icon(playing ? "pause" : "play"));
}

}  // namespace ui
