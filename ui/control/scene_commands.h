#pragma once

#include <QObject>

namespace ui {

class Commands;
class RunController;
class SceneArea;
class SceneEditor;
class SceneGrasp;
class SceneMarker;
class Selection;
class ToolBox;
class WeightMover;
struct SceneMarks;

/// Lets hand and keys work in the scene: select and move weights, show arrows, lay tools on it.
class SceneCommands : public QObject {
  Q_OBJECT

 public:
  /// What there is to work on, as long as the window stands.
  struct Subject {
    SceneEditor* editor;
    Selection* selection;
    RunController* controller;
    ToolBox* tools;
    SceneArea* area;
  };

  SceneCommands(const Commands& commands, const Subject& subject, QObject* parent);

  /// While a weight is dragged its problems stand beside it: a message elsewhere would push the
  /// scene away from under the hand.
  bool isDragging() const;
  const SceneMarks& marks() const;

 signals:
  /// isDragging() is not what it was.
  void draggingChanged(bool dragging);
  /// Something to tell, in words.
  void said(const QString& words);

 private:
  void connectSelection();
  void connectMoves();
  void connectArrows();
  void connectTools();
  void deselect();
  void offerWhatCanBeDone();
  void noteDragging();

  const Commands& m_commands;
  Subject m_subject;
  WeightMover* m_mover;
  ToolBox* m_tools;
  SceneGrasp* m_grasp;
  SceneMarker* m_marker;
  bool m_wasDragging = false;
};

}  // namespace ui
