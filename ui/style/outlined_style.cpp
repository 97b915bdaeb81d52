#include "ui/style/outlined_style.h"

#include <QPainter>
#include <QStyleOption>

namespace ui {

void OutlinedStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                  QPainter* painter, const QWidget* widget) const {
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  if (element != PE_IndicatorCheckBox && element != PE_IndicatorItemViewItemCheck) return;
  // Between ground and text: more than 3 : 1 against the ground in both themes.
  constexpr float kOpacity = 0.6F;
  QColor outline = option->palette.color(QPalette::Active, QPalette::WindowText);
  outline.setAlphaF(kOpacity);
  painter->save();
  painter->setPen(QPen(outline, 1));
  painter->setBrush(Qt::NoBrush);
  painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
  painter->restore();
}

}  // namespace ui
