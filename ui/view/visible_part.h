#pragma once

#include <array>
#include <optional>
#include <vector>

#include <QLineF>
#include <QPointF>
#include <QRectF>

namespace ui {

class Camera;
struct Arrow;
struct Disc;
struct Polyline;

// What of a drawing falls into a picture. Both painters ask here, so that neither meets
// coordinates too large for its arithmetic.

/// The picture with a margin around it, so that what is cut off at its border is not seen [px].
QRectF paintedArea(const Camera& camera);

/// The part of the line inside the rectangle; nothing where it misses.
std::optional<QLineF> lineWithin(const QLineF& line, const QRectF& area);

/// One corner of a polyline on the screen.
struct PolylinePoint {
  QPointF place;  ///< [px]
  double share;   ///< of the way from the polyline's first point (0) to its last (1)
};

/// The stretches of a polyline that are seen, each of at least two points.
std::vector<std::vector<PolylinePoint>> seenStretches(const Polyline& polyline,
                                                      const Camera& camera);

/// Where a disc stands on the screen.
struct PixelDisc {
  QPointF center;  ///< [px]
  double radius;   ///< of the outer edge [px]
};

/// Nothing where the disc is out of the picture, or nowhere because it is not finite.
std::optional<PixelDisc> seenDisc(const Disc& disc, const Camera& camera);

/// An arrow on the screen.
struct ArrowShape {
  QLineF shaft;                 ///< [px], ends where the head begins
  std::array<QPointF, 3> head;  ///< tip and both corners of the base [px]
};

/// An arrow shorter than its head is all head.
ArrowShape arrowShape(const Arrow& arrow, const Camera& camera);

}  // namespace ui
