#include "ui/style/run_mark.h"

#include <QPainter>

#include "ui/style/theme.h"

namespace ui {

QPixmap runMark(int run, const Theme& theme, double devicePixelRatio) {
  constexpr int kSize = 16;  // px
  QPixmap mark(QSize(kSize, kSize) * devicePixelRatio);
  mark.setDevicePixelRatio(devicePixelRatio);
  mark.fill(Qt::transparent);
  QPainter painter(&mark);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor color = theme.runs[static_cast<std::size_t>(run) % theme.runs.size()];
  painter.setPen(QPen(color, 2.5));
  if (run == 0) painter.setBrush(color);
  painter.drawEllipse(QRectF(2, 2, kSize - 4, kSize - 4));
  return mark;
}

}  // namespace ui
