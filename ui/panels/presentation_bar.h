#pragma once

#include <QFrame>

namespace ui {

class Commands;

/// Buttons that lie over the lower edge of a presented scene.
class PresentationBar : public QFrame {
  Q_OBJECT

 public:
  explicit PresentationBar(const Commands& commands, QWidget* parent);

  /// Takes its place in the middle of the parent's lower edge.
  void place();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void sizeButtons();
};

}  // namespace ui
