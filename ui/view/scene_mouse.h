#pragma once

#include <QPointF>

#include "ui/view/scene_hand.h"

class QMouseEvent;

namespace ui {

/// Turns what the mouse does in a view into moves of the view, or lets the hand have it.
class SceneMouse {
 public:
  explicit SceneMouse(SceneView* view) : m_view(view) {}

  /// @param hand  must outlive the view; null: the mouse moves the view alone
  void setHand(SceneHand* hand) { m_hand = hand; }

  void press(const QMouseEvent& event);
  void move(const QMouseEvent& event);
  void release(const QMouseEvent& event);
  /// @return  whether nothing lies there
  bool pressAgain(const QMouseEvent& event);

 private:
  void showCursor(QPointF pixel);

  SceneView* m_view;
  SceneHand* m_hand = nullptr;
  SceneHand::Touch m_touch = SceneHand::Touch::kNothing;
  SceneHand::Touch m_felt = SceneHand::Touch::kNothing;  // what the cursor tells
  bool m_isPressed = false;
  bool m_hasMoved = false;
  QPointF m_last;  // up to where the view was moved [px]
};

}  // namespace ui
