#pragma once

#include <QLabel>

namespace ui {

/// A line or more of small warning text in a color that follows the window's palette.
/// Hidden until it is shown.
class WarningLabel : public QLabel {
  Q_OBJECT

 public:
  explicit WarningLabel(QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void applyColor();
};

}  // namespace ui
