#pragma once

#include <QString>
#include <QWidget>

namespace ui {

class Commands;

/// All keys on one page, in groups that flow into as many columns as the height asks for.
class KeysPage : public QWidget {
  Q_OBJECT

 public:
  /// @param height  that the page may take if words have room side by side [px]
  KeysPage(const Commands& commands, int height, QWidget* parent = nullptr);
};

}  // namespace ui
