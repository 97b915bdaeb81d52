#include "ui/panels/wheel_guard.h"

#include <QEvent>
#include <QWidget>

namespace ui {
namespace {

class WheelGuard : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const auto* widget = static_cast<QWidget*>(watched);
    if (event->type() != QEvent::Wheel || widget->hasFocus()) return false;
    event->ignore();  // so that it goes on to the form
    return true;
  }
};

}  // namespace

void ignoreWheelWithoutFocus(QWidget* widget) {
  widget->installEventFilter(new WheelGuard(widget));
}

}  // namespace ui
