#pragma once

#include <QObject>

#include "ui/view/scene_hand.h"

namespace ui {

class Selection;
class ToolBox;
class WeightMover;

/// The hand in the scene: tools lie above weights; a click selects a weight, or none where none
/// is, and a press takes hold of it if it can be moved now.
class SceneGrasp : public QObject, public SceneHand {
  Q_OBJECT

 public:
  SceneGrasp(Selection* selection, WeightMover* mover, ToolBox* tools, QObject* parent = nullptr);

  Touch touch(const SceneView& view, QPointF pixel) override;
  void drag(const SceneView& view, QPointF pixel, Qt::KeyboardModifiers modifiers) override;
  void release(Touch touch, bool moved) override;
  Touch feel(const SceneView& view, QPointF pixel) const override;

 signals:
  /// The stopwatch was clicked, not moved.
  void stopwatchClicked();
  /// Somebody tried to move a weight that cannot be moved now.
  void heldFast();

 private:
  bool isTool(const SceneView& view, QPointF pixel) const;

  Selection* m_selection;
  WeightMover* m_mover;
  ToolBox* m_tools;
};

}  // namespace ui
