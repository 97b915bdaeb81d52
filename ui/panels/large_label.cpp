#include "ui/panels/large_label.h"

#include <QEvent>

namespace ui {

LargeLabel::LargeLabel(double share, const QString& longest, QWidget* parent)
    : QLabel(parent), m_share(share), m_longest(longest) {
  if (parent) followParent();
}

bool LargeLabel::event(QEvent* event) {
  if (event->type() == QEvent::ParentChange && parentWidget()) followParent();
  return QLabel::event(event);
}

void LargeLabel::followParent() {
  parentWidget()->installEventFilter(this);
  applySize();
}

bool LargeLabel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::FontChange) applySize();
  return QLabel::eventFilter(watched, event);
}

void LargeLabel::applySize() {
  QFont large = parentWidget()->font();
  large.setPointSizeF(large.pointSizeF() * m_share);
  large.setBold(true);
  setFont(large);
  if (!m_longest.isEmpty()) setMinimumWidth(fontMetrics().horizontalAdvance(m_longest));
}

}  // namespace ui
