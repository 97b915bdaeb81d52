#pragma once

#include <QPointF>
#include <QRectF>

namespace ui {

// What a chart shows after a zoom or a move. Ranges are in the units of the axes and have
// their lowest y as top().

/// Larger by `factor` about a point that stays where it is; a factor of 1 leaves a direction
/// as it is.
QRectF zoomedAbout(const QRectF& range, QPointF fixed, double factorX, double factorY);

/// Moved by a share of its size.
QRectF movedBy(const QRectF& range, double shareX, double shareY);

/// Whether numbers can still tell the ends of this range apart, and reach them.
bool canBeShown(const QRectF& range);

}  // namespace ui
