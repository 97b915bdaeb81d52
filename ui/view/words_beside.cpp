#include "ui/view/words_beside.h"

#include <cmath>

namespace ui {

QPointF cornerBeside(QPointF from, QPointF to, QSizeF box, double gap) {
  const QPointF way = to - from;
  const double length = std::hypot(way.x(), way.y());
  QPointF normal = length > 0 ? QPointF(-way.y(), way.x()) / length : QPointF(0, -1);
  const bool isUpright = std::abs(normal.y()) < 1e-9;
  if (isUpright ? normal.x() < 0 : normal.y() > 0) normal = -normal;
  const double reach =
      std::abs(normal.x()) * box.width() / 2 + std::abs(normal.y()) * box.height() / 2 + gap;
  return (from + to) / 2 + normal * reach - QPointF(box.width() / 2, box.height() / 2);
}

}  // namespace ui
