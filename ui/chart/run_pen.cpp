#include "ui/chart/run_pen.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {

namespace {

// Dashes and gaps in multiples of the line's width.
const std::array<QList<double>, 4> kPatterns = {QList<double>{}, QList<double>{4, 2},
                                                QList<double>{1, 2}, QList<double>{6, 2, 1, 2}};

double pixelLength(const QList<QPointF>& curve, QSizeF unit) {
  double length = 0;
  for (qsizetype i = 1; i < curve.size(); ++i) {
    const QPointF way = curve[i] - curve[i - 1];
    length += std::hypot(way.x() * unit.width(), way.y() * unit.height());
  }
  return length;
}

}  // namespace

QPen runPen(const QColor& color, double width, std::size_t run) {
  QPen pen(color, width);
  const QList<double>& pattern = kPatterns[run % kPatterns.size()];
  if (pattern.isEmpty()) {
    // Solid curves are painted piece by piece, and flat ends would leave gaps at bends.
    pen.setCapStyle(Qt::SquareCap);
  } else {
    pen.setCapStyle(Qt::FlatCap);
    pen.setDashPattern(pattern);
  }
  return pen;
}

bool isTooDenseForDashes(const QList<QPointF>& curve, QSizeF unit) {
  constexpr double kLongestDashed = 5000;  // [px]
  return pixelLength(curve, unit) > kLongestDashed;
}

bool isTooDenseForSmoothLines(const QList<QPointF>& curve, QSizeF unit) {
  constexpr double kLongestSmooth = 30000;  // [px]
  return pixelLength(curve, unit) > kLongestSmooth;
}

QPen densePen(const QColor& color) {
  return QPen(color, 1);
}

}  // namespace ui
