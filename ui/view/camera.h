#pragma once

#include <Eigen/Core>

#include <QMarginsF>
#include <QPointF>
#include <QRectF>
#include <QSizeF>

namespace ui {

/// Where the room lies on the screen: metres with y up ↔ logical pixels with y down.
///
/// A value without a window. The center of the viewport never leaves the room, so that the
/// room cannot be lost by panning.
class Camera {
 public:
  /// Most that one metre may fill [px]: a micrometre is ten pixels wide then.
  static constexpr double kLargestScale = 1e7;
  /// How much smaller than fitted the room may be shown.
  static constexpr double kSmallestShare = 0.25;

  /// Changes the size of the picture; its center and scale stay.
  /// @param size              [logical px], both sides > 0
  /// @param devicePixelRatio  device pixels per logical one, > 0
  void setViewport(QSizeF size, double devicePixelRatio = 1);

  /// Shows the whole room, as large as it goes with these margins around it [px].
  /// @param room  width and height [m], > 0
  void fit(QSizeF room, QMarginsF margins);

  /// Enlarges by `factor` > 0, within the limits, so that `pixel` keeps showing the same place.
  void zoomAt(QPointF pixel, double factor);

  /// Moves the picture by so many pixels.
  void panBy(QPointF pixels);

  QSizeF viewport() const { return m_viewport; }
  double devicePixelRatio() const { return m_devicePixelRatio; }
  double scale() const { return m_scale; }  ///< [logical px/m]
  QPointF toPixels(const Eigen::Vector2d& metres) const;
  Eigen::Vector2d toMetres(QPointF pixel) const;

  /// The part of the plane that is seen: x and y of its lower left corner, and its size [m].
  QRectF visibleMetres() const;

  /// The nearest edge between two device pixels: rectangles that end there are crisp.
  double snapped(double pixel) const;

  bool operator==(const Camera&) const = default;

 private:
  void keepCenterInRoom();

  QSizeF m_viewport{1, 1};
  double m_devicePixelRatio = 1;
  QSizeF m_room{1, 1};
  double m_fittedScale = 1;
  double m_scale = 1;
  QPointF m_center;  // [m], y up
};

}  // namespace ui
