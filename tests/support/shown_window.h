#pragma once

#include <QSize>
#include <QTest>

#include "core/scene/scene.h"
#include "ui/control/run_controller.h"
#include "ui/main_window.h"

namespace tests {

constexpr QSize kProjector(1280, 720);  ///< the smallest that is common in class rooms [px]

/// Shows a window and waits until the keyboard is its own.
inline void showInFront(QWidget& window) {
  window.show();
  if (!QTest::qWaitForWindowActive(&window)) qFatal("the window is not active");
}

/// The program's window in front, whose work takes no time.
class ShownWindow : public ui::MainWindow {
 public:
  explicit ShownWindow(const core::Scene& scene, QSize size = kProjector) : MainWindow(scene) {
    controller()->setStopwatch([] { return 0.0; });
    setWindowState(Qt::WindowNoState);
    resize(size);
    showInFront(*this);
  }

  double time() const { return controller()->time(); }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(this, key, modifiers);
  }
};

}  // namespace tests
