#pragma once

#include <vector>

#include <QPointF>
#include <QRectF>
#include <QSizeF>

namespace ui {

/// A curve that wants a label beside it [px].
struct LabelledCurve {
  std::vector<QPointF> points;
  QSizeF label;  ///< of its text
};

/// Where each curve's label covers no curve and no other label: beside one of the curve's own
/// points, the later ones first. Where there is no such place, where it covers the least.
///
/// @param area  labels stay inside
/// @param gap   between label and point
/// @return      one place for each curve; an empty one for a curve without points
std::vector<QRectF> labelPlaces(const std::vector<LabelledCurve>& curves, const QRectF& area,
                                double gap);

}  // namespace ui
