#include "ui/panels/warning_label.h"

#include <QEvent>

#include "ui/style/theme.h"

namespace ui {

WarningLabel::WarningLabel(QWidget* parent) : QLabel(parent) {
  setWordWrap(true);
  setVisible(false);
  applyColor();
}

void WarningLabel::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) applyColor();
}

void WarningLabel::applyColor() {
  const QColor color = Theme::of(palette()).drift;
  if (palette().color(QPalette::WindowText) == color) return;
  QPalette own;
  own.setColor(QPalette::WindowText, color);
  setPalette(own);
}

}  // namespace ui
