#pragma once

class QWidget;

namespace ui {

/// Lets the wheel scroll the form, not change the value it happens to pass over: the widget
/// heeds it only while it has the focus.
void ignoreWheelWithoutFocus(QWidget* widget);

}  // namespace ui
