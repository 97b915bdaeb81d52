#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include <QFont>
#include <QPointF>
#include <QRgb>
#include <QString>

namespace ui {

// What a picture of the scene is made of: places and sizes of things in metres with y up,
// widths of strokes in logical pixels, colors not premultiplied. Painters draw it; it knows
// no window and no OpenGL.

/// A filled upright rectangle.
struct Rectangle {
  Eigen::Vector2d lower;  ///< lower left corner [m]
  Eigen::Vector2d upper;  ///< upper right corner [m]
  QRgb color;
};

/// A straight stroke with round ends.
struct Line {
  Eigen::Vector2d from;  ///< [m]
  Eigen::Vector2d to;    ///< [m]
  double width;          ///< [px]
  QRgb color;
};

/// A stroke through many points.
struct Polyline {
  std::vector<Eigen::Vector2d> points;  ///< [m]
  double width;                         ///< at the last point [px]
  QRgb color;                           ///< at the last point
  bool fading;                          ///< towards the first point it thins out and vanishes
};

/// A stroke that ends in a head.
struct Arrow {
  Eigen::Vector2d from;  ///< [m]
  Eigen::Vector2d to;    ///< the tip [m]
  double width;          ///< of the shaft [px]; the head follows from it
  QRgb color;
};

/// A disc, a ring where the fill is transparent.
struct Disc {
  Eigen::Vector2d center;  ///< [m]
  double radius;           ///< of the outer edge [m]
  double margin;           ///< added to the radius [px]
  double outlineWidth;     ///< inside the outer edge [px]
  QRgb fill;
  QRgb outline;
};

/// One line of words.
struct Text {
  Eigen::Vector2d at;  ///< [m]
  QPointF offset;      ///< from there to the upper left corner of the words' box [px]
  QString words;
  QFont font;  ///< its size in pixels
  QRgb color;
  QRgb plate = 0;  ///< behind the words; transparent: none
};

/// Shapes of one depth, painted in the order of the members.
struct Layer {
  std::vector<Rectangle> rectangles;
  std::vector<Polyline> polylines;
  std::vector<Line> lines;
  std::vector<Arrow> arrows;
  std::vector<Disc> discs;
};

/// Depths from back to front.
enum LayerIndex {
  kRoomLayer,
  kTrailLayer,
  kRopeLayer,
  kWeightLayer,
  kFrontLayer,
  kToolLayer,
  kLayerCount
};

/// A whole picture. Texts lie over all layers.
struct Drawing {
  QRgb background = 0xffffffff;
  std::array<Layer, kLayerCount> layers;
  std::vector<Text> texts;
};

/// Length of an arrow's head, and its full width at the base, in widths of the shaft.
inline constexpr double kArrowHeadLength = 4;
inline constexpr double kArrowHeadWidth = 3.5;

/// Share of a fading polyline's opacity at `share` of its way from the first point (0) to
/// the last (1).
inline double fadedOpacity(double share) {
  return share * std::sqrt(share);
}

/// The same for its width.
inline double fadedWidth(double share) {
  return 0.3 + 0.7 * share;
}

}  // namespace ui
