#include "ui/view/qpainter_renderer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <QFontMetricsF>
#include <QImage>
#include <QPainter>

#include "ui/view/camera.h"
#include "ui/view/shape.h"
#include "ui/view/shape_raster.h"
#include "ui/view/visible_part.h"

namespace ui {

namespace {

// A fading polyline is painted in so many strokes of even color: the steps between them are
// too small to be seen.
constexpr int kFadeSteps = 24;

QPen strokePen(QRgb color, double width, Qt::PenCapStyle cap) {
  return QPen(QColor::fromRgba(color), width, Qt::SolidLine, cap, Qt::RoundJoin);
}

QRgb withAlphaTimes(QRgb color, double opacity) {
  return qRgba(qRed(color), qGreen(color), qBlue(color),
               static_cast<int>(std::lround(qAlpha(color) * opacity)));
}

void paintRectangles(const std::vector<Rectangle>& rectangles, const Camera& camera,
                     QPainter& painter) {
  for (const Rectangle& rectangle : rectangles) {
    const QRectF box(camera.toPixels({rectangle.lower.x(), rectangle.upper.y()}),
                     camera.toPixels({rectangle.upper.x(), rectangle.lower.y()}));
    painter.fillRect(box, QColor::fromRgba(rectangle.color));
  }
}

void paintEven(const std::vector<PolylinePoint>& stretch, const Polyline& polyline,
               QPainter& painter) {
  QPolygonF places;
  for (const PolylinePoint& point : stretch) places << point.place;
  painter.setPen(strokePen(polyline.color, polyline.width, Qt::RoundCap));
  painter.drawPolyline(places);
}

void paintFading(const std::vector<PolylinePoint>& stretch, const Polyline& polyline,
                 QPainter& painter) {
  std::size_t first = 0;
  while (first + 1 < stretch.size()) {
    QPolygonF places{stretch[first].place};
    std::size_t next = first + 1;
    const double endOfStep = stretch[first].share + 1.0 / kFadeSteps;
    for (; next < stretch.size(); ++next) {
      places << stretch[next].place;
      if (stretch[next].share >= endOfStep) break;
    }
    next = std::min(next, stretch.size() - 1);
    const double share = (stretch[first].share + stretch[next].share) / 2;
    painter.setPen(strokePen(withAlphaTimes(polyline.color, fadedOpacity(share)),
                             polyline.width * fadedWidth(share), Qt::FlatCap));
    painter.drawPolyline(places);
    first = next;
  }
}

void paintPolylines(const std::vector<Polyline>& polylines, const Camera& camera,
                    QPainter& painter) {
  painter.setBrush(Qt::NoBrush);
  for (const Polyline& polyline : polylines)
    for (const std::vector<PolylinePoint>& stretch : seenStretches(polyline, camera))
      (polyline.fading ? paintFading : paintEven)(stretch, polyline, painter);
}

void paintLines(const std::vector<Line>& lines, const Camera& camera, QPainter& painter) {
  const QRectF area = paintedArea(camera);
  for (const Line& line : lines) {
    const auto seen =
        lineWithin(QLineF(camera.toPixels(line.from), camera.toPixels(line.to)), area);
    if (!seen) continue;
    painter.setPen(strokePen(line.color, line.width, Qt::RoundCap));
    painter.drawLine(*seen);
  }
}

void paintArrows(const std::vector<Arrow>& arrows, const Camera& camera, QPainter& painter) {
  for (const Arrow& arrow : arrows) {
    const ArrowShape shape = arrowShape(arrow, camera);
    painter.setPen(strokePen(arrow.color, arrow.width, Qt::FlatCap));
    painter.drawLine(shape.shaft);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor::fromRgba(arrow.color));
    painter.drawPolygon(shape.head.data(), static_cast<int>(shape.head.size()));
  }
}

void paintDiscs(const std::vector<Disc>& discs, const Camera& camera, QPainter& painter) {
  for (const Disc& disc : discs) {
    const std::optional<PixelDisc> seen = seenDisc(disc, camera);
    if (!seen) continue;
    // A pen is painted half inside and half outside of the ellipse it follows.
    const double radius = seen->radius - disc.outlineWidth / 2;
    const bool outlined = disc.outlineWidth > 0;
    painter.setPen(outlined ? strokePen(disc.outline, disc.outlineWidth, Qt::FlatCap)
                            : QPen(Qt::NoPen));
    painter.setBrush(qAlpha(disc.fill) > 0 ? QBrush(QColor::fromRgba(disc.fill)) : Qt::NoBrush);
    painter.drawEllipse(seen->center, radius, radius);
  }
}

}  // namespace

void paintTexts(const std::vector<Text>& texts, const Camera& camera, QPainter& painter) {
  for (const Text& text : texts) {
    const QPointF corner = camera.toPixels(text.at) + text.offset;
    const QFontMetricsF metrics(text.font);
    if (qAlpha(text.plate) > 0) {
      const QRectF box(corner, QSizeF(metrics.horizontalAdvance(text.words), metrics.height()));
      painter.setPen(Qt::NoPen);
      painter.setBrush(QColor::fromRgba(text.plate));
      painter.drawRoundedRect(box.adjusted(-4, -1, 4, 1), 4, 4);
    }
    painter.setFont(text.font);
    painter.setPen(QColor::fromRgba(text.color));
    painter.drawText(corner + QPointF(0, metrics.ascent()), text.words);
  }
}

void paintDrawing(const Drawing& drawing, const Camera& camera, QPainter& painter) {
  painter.fillRect(QRectF(QPointF(0, 0), camera.viewport()), QColor::fromRgba(drawing.background));
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Layer& layer : drawing.layers) {
    paintRectangles(layer.rectangles, camera, painter);
    paintPolylines(layer.polylines, camera, painter);
    paintLines(layer.lines, camera, painter);
    paintArrows(layer.arrows, camera, painter);
    paintDiscs(layer.discs, camera, painter);
  }
  paintTexts(drawing.texts, camera, painter);
}

void paintDrawing(const Drawing& drawing, const Camera& camera, QImage& image) {
  image.fill(drawing.background);
  std::vector<Shape> shapes;
  for (const Layer& layer : drawing.layers) {
    addRectangles(layer, camera, shapes);
    addShapes(layer, camera, shapes);
  }
  paintShapes(shapes, image);
  QPainter painter(&image);
  painter.scale(camera.devicePixelRatio(), camera.devicePixelRatio());
  painter.setRenderHint(QPainter::Antialiasing);
  paintTexts(drawing.texts, camera, painter);
}

}  // namespace ui
