#pragma once

#include <QObject>

#include "ui/view/scene_marks.h"

namespace ui {

class RunController;
class SceneEditor;
class Selection;
class ToolBox;
class WeightMover;

/// Decides what is drawn over the runs: the selected weight, arrows, tools.
class SceneMarker : public QObject {
  Q_OBJECT

 public:
  /// Whose state is drawn.
  struct Sources {
    const SceneEditor* editor;
    const Selection* selection;
    const RunController* controller;
    WeightMover* mover;
    const ToolBox* tools;
  };

  explicit SceneMarker(const Sources& sources, QObject* parent = nullptr);

  const SceneMarks& marks() const { return m_marks; }

 public slots:
  void showVelocities(bool shown);
  void showForces(bool shown);
  void showTensions(bool shown);

 signals:
  void marksChanged(const SceneMarks& marks);

 private:
  void scaleArrows();
  void mark();
  void noteTime();
  std::optional<ShownSelection> selected() const;
  std::optional<core::Weight> rejected(std::size_t index) const;

  Sources m_sources;
  SceneMarks m_marks;
};

}  // namespace ui
