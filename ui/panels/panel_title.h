#pragma once

#include <QWidget>

class QDockWidget;

namespace ui {

/// The line above a panel: its name, something of its own, and buttons to float and close
/// it. Dragging the line moves the panel.
class PanelTitle : public QWidget {
  Q_OBJECT

 public:
  /// @param extra  stands behind the name; may be null
  PanelTitle(QDockWidget* panel, QWidget* extra);
};

}  // namespace ui
