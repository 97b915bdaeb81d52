#pragma once

#include <QDockWidget>

namespace tests {

/// Whether a widget is in a panel that stands behind another one, where Qt leaves it as it was when
/// it was seen last.
inline bool isBehindATab(const QWidget* widget) {
  while (widget && !qobject_cast<const QDockWidget*>(widget)) widget = widget->parentWidget();
  const auto* dock = qobject_cast<const QDockWidget*>(widget);
  return dock && !dock->widget()->isVisible();
}

}  // namespace tests
