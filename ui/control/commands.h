#pragma once

#include <map>
#include <vector>

#include <QObject>

class QAction;

namespace ui {

/// Everything the window can be told to do by menu, key or button.
enum class Command {
  kNew,
  kOpen,
  kLessons,
  kSave,
  kSaveAs,
  kExportChart,
  kExportPicture,
  kQuit,
  kUndo,
  kRedo,
  kWeightsTable,
  kPlay,
  kStep,
  kStepBack,
  kStepFrame,
  kStepFrameBack,
  kCut,
  kReset,
  kSlower,
  kFaster,
  kSplit,
  kNextEvent,
  kPreviousEvent,
  kNextImpact,
  kPreviousImpact,
  kNextTurningPoint,
  kPreviousTurningPoint,
  kNextCut,
  kPreviousCut,
  kGoToStart,
  kGoToEnd,
  kGoTo,
  kStopTravelling,
  kMeasure,
  kWhenToCut,
  kTrails,
  kVelocities,
  kForces,
  kTensions,
  kTarget,
  kTape,
  kProtractor,
  kStopwatch,
  kStartStopwatch,
  kZeroStopwatch,
  kNextToolPart,
  kLessonText,
  kFit,
  kZoomIn,
  kZoomOut,
  kPresent,
  kNextWeight,
  kPreviousWeight,
  kDeselect,
  kMoveLeft,
  kMoveRight,
  kMoveUp,
  kMoveDown,
  kAccelerateLeft,
  kAccelerateRight,
  kAccelerateUp,
  kAccelerateDown,
  kNextChart,
  kPreviousChart,
  kChartReset,
  kCopyChart,
  kCopyChartData,
  kSheet,
  kGuide,
  kModel,
  kTour,
  kKeys,
  kAbout,
};

/// One action for each command, with its words, keys and icon.
class Commands : public QObject {
  Q_OBJECT

 public:
  explicit Commands(QObject* parent = nullptr);

  QAction* action(Command command) const { return m_actions.at(command); }
  /// In the order of the menus.
  std::vector<QAction*> all() const;
  const std::map<Command, QAction*>& byCommand() const { return m_actions; }

  /// Lets the play action offer what it does now.
  void showPlaying(bool playing) const;

 private:
  std::map<Command, QAction*> m_actions;
};

}  // namespace ui
