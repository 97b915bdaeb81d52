#pragma once

#include <Eigen/Core>

#include <QTest>

#include "ui/main_window.h"
#include "ui/view/camera.h"
#include "ui/view/scene_area.h"
#include "ui/view/scene_view.h"

namespace tests {

/// A hand with a mouse in the scene of a window. Places are in the room [m].
class WindowHand {
 public:
  explicit WindowHand(const ui::MainWindow& window) : m_area(window.findChild<ui::SceneArea*>()) {}

  ui::SceneView* view() const { return m_area->views().front(); }
  QPoint pixel(const Eigen::Vector2d& place) const {
    return view()->camera().toPixels(place).toPoint();
  }
  Eigen::Vector2d place(QPointF pixel) const { return view()->camera().toMetres(pixel); }
  /// How wide a pixel is [m].
  double grain() const { return 1 / view()->camera().scale(); }

  void click(const Eigen::Vector2d& place, QPoint beside = {}) const {
    QTest::mouseClick(view(), Qt::LeftButton, {}, pixel(place) + beside);
  }
  void press(QPoint at) const { QTest::mousePress(view(), Qt::LeftButton, {}, at); }
  void move(QPoint to, Qt::KeyboardModifiers modifiers = {}) const {
    QMouseEvent event(QEvent::MouseMove, to, view()->mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                      modifiers);
    QCoreApplication::sendEvent(view(), &event);
  }
  void release(QPoint at) const { QTest::mouseRelease(view(), Qt::LeftButton, {}, at); }

  /// From one pixel to another, over some between them.
  void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) const {
    press(from);
    for (int i = 1; i <= 4; ++i) move(from + (to - from) * i / 4, modifiers);
    release(to);
  }
  void drag(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
            Qt::KeyboardModifiers modifiers = {}) const {
    drag(pixel(from), pixel(to), modifiers);
  }

 private:
  ui::SceneArea* m_area;
};

}  // namespace tests
