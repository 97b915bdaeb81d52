#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <QPointF>
#include <QRgb>

namespace ui {

class Camera;
struct Layer;

/// How a shape ends.
enum class ShapeEnds : std::uint8_t {
  kJoined,  ///< hard, along its edges: the next shape goes on there
  kRound,
  kFlat,  ///< antialiased, across the shape
};

/// The one form that all shapes of a drawing take on their way to pixels: a straight stroke
/// that may taper. A disc is a stroke of no length with round ends, and may have an outline.
///
/// Coverage and color of a pixel follow from its center's distance to the axis; the formula
/// stands twice, for the processor in shape_raster.cpp and for OpenGL in
/// resources/shaders/shape.frag, and a test compares what they show.
///
/// All lengths in device pixels, y down, pixel (0, 0) reaching from 0 to 1; plain floats in
/// the layout that OpenGL reads; colors as red, green, blue, alpha, premultiplied.
struct Shape {
  using Color = std::array<std::uint8_t, 4>;

  std::array<float, 2> from;
  std::array<float, 2> to;
  std::array<float, 2> fromEdge;  ///< direction of the edge at `from`, where joined: as long
  std::array<float, 2> toEdge;    ///< as one pixel of half width reaches along it
  float fromHalfWidth;
  float toHalfWidth;
  float outlineWidth;  ///< inside the half width
  float ends;          ///< a ShapeEnds
  Color color;
  Color outline;
};

Shape discShape(QPointF center, double radius, double outlineWidth, QRgb fill, QRgb outline);
Shape strokeShape(QPointF from, QPointF to, double width, QRgb color, ShapeEnds ends);

/// Adds the rectangles of a layer.
void addRectangles(const Layer& layer, const Camera& camera, std::vector<Shape>& shapes);

/// Adds all of a layer but its rectangles, in the order to paint.
void addShapes(const Layer& layer, const Camera& camera, std::vector<Shape>& shapes);

}  // namespace ui
