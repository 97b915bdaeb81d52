#include "ui/view/shape.h"

#include <cmath>

#include "ui/view/camera.h"
#include "ui/view/drawing.h"
#include "ui/view/visible_part.h"

namespace ui {

namespace {

std::array<float, 2> floats(QPointF point) {
  return {static_cast<float>(point.x()), static_cast<float>(point.y())};
}

Shape::Color premultiplied(QRgb color, double opacity = 1) {
  const double alpha = qAlpha(color) / 255.0 * opacity;
  const auto channel = [alpha](int value) {
    return static_cast<std::uint8_t>(value * alpha + 0.5);
  };
  return {channel(qRed(color)), channel(qGreen(color)), channel(qBlue(color)), channel(255)};
}

/// Unit vector across the way from one point to the next.
QPointF normalOf(QPointF from, QPointF to) {
  const QPointF way = to - from;
  const double length = std::sqrt(QPointF::dotProduct(way, way));
  if (length == 0) return {0, 1};
  return QPointF(-way.y(), way.x()) / length;
}

/// The edge between two stretches of a polyline: their bisector, as long as one pixel of half
/// width reaches along it. At sharp turns it would reach far out, so each stretch ends across.
QPointF joint(QPointF normal, QPointF otherNormal) {
  constexpr double kSharpest = 0.25;  // cosine of half the turn, the edge being 4 px a px long
  const QPointF sum = (normal + otherNormal) / 2;
  const double square = QPointF::dotProduct(sum, sum);
  if (square < kSharpest * kSharpest) return normal;
  return sum / square;
}

void addStretch(const std::vector<PolylinePoint>& stretch, const Polyline& polyline, double ratio,
                std::vector<Shape>& shapes) {
  const auto normal = [&stretch](std::size_t i) {
    return normalOf(stretch[i].place, stretch[i + 1].place);
  };
  const std::size_t count = stretch.size() - 1;
  for (std::size_t i = 0; i < count; ++i) {
    const QPointF here = normal(i);
    Shape shape = strokeShape(stretch[i].place * ratio, stretch[i + 1].place * ratio,
                              polyline.width * ratio, polyline.color, ShapeEnds::kJoined);
    shape.fromEdge = floats(i > 0 ? joint(here, normal(i - 1)) : here);
    shape.toEdge = floats(i + 1 < count ? joint(here, normal(i + 1)) : here);
    if (polyline.fading) {
      const double middle = (stretch[i].share + stretch[i + 1].share) / 2;
      shape.color = premultiplied(polyline.color, fadedOpacity(middle));
      shape.fromHalfWidth *= static_cast<float>(fadedWidth(stretch[i].share));
      shape.toHalfWidth *= static_cast<float>(fadedWidth(stretch[i + 1].share));
    }
    shapes.push_back(shape);
  }
}

void addArrow(const Arrow& arrow, const Camera& camera, std::vector<Shape>& shapes) {
  const double ratio = camera.devicePixelRatio();
  const ArrowShape pixels = arrowShape(arrow, camera);
  shapes.push_back(strokeShape(pixels.shaft.p1() * ratio, pixels.shaft.p2() * ratio,
                               arrow.width * ratio, arrow.color, ShapeEnds::kFlat));
  shapes.push_back(strokeShape(pixels.shaft.p2() * ratio, pixels.head[0] * ratio,
                               kArrowHeadWidth * arrow.width * ratio, arrow.color,
                               ShapeEnds::kFlat));
  shapes.back().toHalfWidth = 0;
}

}  // namespace

Shape discShape(QPointF center, double radius, double outlineWidth, QRgb fill, QRgb outline) {
  Shape shape = strokeShape(center, center, 2 * radius, fill, ShapeEnds::kRound);
  shape.outlineWidth = static_cast<float>(outlineWidth);
  shape.outline = premultiplied(outline);
  return shape;
}

Shape strokeShape(QPointF from, QPointF to, double width, QRgb color, ShapeEnds ends) {
  const auto half = static_cast<float>(width / 2);
  const std::array<float, 2> edge = floats(normalOf(from, to));
  const Shape::Color fill = premultiplied(color);
  return {floats(from), floats(to), edge, edge, half, half, 0, static_cast<float>(ends),
          fill,         fill};
}

void addRectangles(const Layer& layer, const Camera& camera, std::vector<Shape>& shapes) {
  const double ratio = camera.devicePixelRatio();
  for (const Rectangle& rectangle : layer.rectangles) {
    const QPointF lower = camera.toPixels(rectangle.lower) * ratio;
    const QPointF upper = camera.toPixels(rectangle.upper) * ratio;
    const double middle = (lower.y() + upper.y()) / 2;
    shapes.push_back(strokeShape({lower.x(), middle}, {upper.x(), middle}, lower.y() - upper.y(),
                                 rectangle.color, ShapeEnds::kFlat));
  }
}

void addShapes(const Layer& layer, const Camera& camera, std::vector<Shape>& shapes) {
  const double ratio = camera.devicePixelRatio();
  const QRectF area = paintedArea(camera);
  for (const Polyline& polyline : layer.polylines)
    for (const std::vector<PolylinePoint>& stretch : seenStretches(polyline, camera))
      addStretch(stretch, polyline, ratio, shapes);
  for (const Line& line : layer.lines) {
    const QLineF pixels(camera.toPixels(line.from), camera.toPixels(line.to));
    if (const std::optional<QLineF> seen = lineWithin(pixels, area))
      shapes.push_back(strokeShape(seen->p1() * ratio, seen->p2() * ratio, line.width * ratio,
                                   line.color, ShapeEnds::kRound));
  }
  for (const Arrow& arrow : layer.arrows) addArrow(arrow, camera, shapes);
  for (const Disc& disc : layer.discs)
    if (const std::optional<PixelDisc> seen = seenDisc(disc, camera))
      shapes.push_back(discShape(seen->center * ratio, seen->radius * ratio,
                                 disc.outlineWidth * ratio, disc.fill, disc.outline));
}

}  // namespace ui
