#include "ui/chart/chart_zoom.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

bool isFineEnough(double lowest, double size) {
  constexpr double kLeastShare = 1e-9;  // of the values: labels would need more digits
  constexpr double kMostSize = 1e12;
  const double largest = std::max(std::abs(lowest), std::abs(lowest + size));
  return size > kLeastShare * largest && size > 1e-12 && largest < kMostSize;
}

}  // namespace

QRectF zoomedAbout(const QRectF& range, QPointF fixed, double factorX, double factorY) {
  const QPointF corner(fixed.x() - (fixed.x() - range.left()) / factorX,
                       fixed.y() - (fixed.y() - range.top()) / factorY);
  return {corner, QSizeF(range.width() / factorX, range.height() / factorY)};
}

QRectF movedBy(const QRectF& range, double shareX, double shareY) {
  return range.translated(shareX * range.width(), shareY * range.height());
}

bool canBeShown(const QRectF& range) {
  return isFineEnough(range.left(), range.width()) && isFineEnough(range.top(), range.height());
}

}  // namespace ui
