#include "ui/view/shape_raster.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <future>
#include <thread>

#include <QImage>

#include "ui/view/shape.h"

namespace ui {

namespace {

// Colors are premultiplied; a share of 256 is the whole.
constexpr unsigned kWhole = 256;

/// Two channels at a time in one multiplication each.
QRgb scaled(QRgb color, unsigned share) {
  const unsigned redBlue = ((color & 0x00ff00ff) * share >> 8) & 0x00ff00ff;
  const unsigned alphaGreen = ((color >> 8) & 0x00ff00ff) * share & 0xff00ff00;
  return redBlue | alphaGreen;
}

/// @return  opaque, as the image is
QRgb over(QRgb source, QRgb below) {
  const unsigned rest = 255 - qAlpha(source);
  return (source + scaled(below, rest + (rest >> 7))) | 0xff000000;
}

QRgb colorOf(const Shape::Color& color) {
  return qRgba(color[0], color[1], color[2], color[3]);
}

unsigned shareOf(float value) {
  return static_cast<unsigned>(std::clamp(value, 0.0f, 1.0f) * static_cast<float>(kWhole));
}

float lengthOf(float x, float y) {
  return std::sqrt(x * x + y * y);
}

/// First and last pixel of a row or column that an interval covers; none where first > last.
struct PixelRange {
  int first;
  int last;
};

// Truncation rounds down, for nothing below zero comes here; std::floor would be a call.
PixelRange pixelsWithin(float lowest, float highest, int size) {
  const float end = static_cast<float>(size);
  const int first = static_cast<int>(std::clamp(lowest + 0.5f, 0.0f, end));
  const int behind = static_cast<int>(std::clamp(highest + 0.5f, 0.0f, end));
  return {first, behind - 1};
}

/// The pixels that are painted into: of all rows every `rowStep`-th, from `firstRow` on.
class Canvas {
 public:
  explicit Canvas(QImage& image, int firstRow = 0, int rowStep = 1)
      : m_bits(image.bits()),
        m_stride(image.bytesPerLine()),
        m_width(image.width()),
        m_height(image.height()),
        m_firstRow(firstRow),
        m_rowStep(rowStep) {}

  QRgb* row(int y) const { return reinterpret_cast<QRgb*>(m_bits + y * m_stride); }
  /// To go through by rowStep().
  PixelRange rows(float lowest, float highest) const {
    PixelRange rows = pixelsWithin(lowest, highest, m_height);
    while (rows.first % m_rowStep != m_firstRow) ++rows.first;
    return rows;
  }
  int rowStep() const { return m_rowStep; }
  PixelRange columns(float lowest, float highest) const {
    return pixelsWithin(lowest, highest, m_width);
  }

 private:
  uchar* m_bits;
  qsizetype m_stride;
  int m_width;
  int m_height;
  int m_firstRow;
  int m_rowStep;
};

void paintDisc(const Shape& disc, const Canvas& canvas) {
  const QRgb fill = colorOf(disc.color);
  const QRgb outline = colorOf(disc.outline);
  const bool isOutlined = disc.outlineWidth > 0;
  const float reach = disc.fromHalfWidth + 0.5f;
  const float innerRadius = disc.fromHalfWidth - disc.outlineWidth;
  // Inside of this a pixel is all fill; squared, which most pixels are settled by without a root.
  const float plain = isOutlined ? std::max(innerRadius - 0.5f, 0.0f) : reach - 1;
  const float plainSquare = plain * std::abs(plain);
  const PixelRange rows = canvas.rows(disc.from[1] - reach, disc.from[1] + reach);
  for (int y = rows.first; y <= rows.last; y += canvas.rowStep()) {
    const float dy = static_cast<float>(y) + 0.5f - disc.from[1];
    const float half = std::sqrt(std::max(reach * reach - dy * dy, 0.0f));
    const PixelRange columns = canvas.columns(disc.from[0] - half, disc.from[0] + half);
    QRgb* const row = canvas.row(y);
    for (int x = columns.first; x <= columns.last; ++x) {
      const float dx = static_cast<float>(x) + 0.5f - disc.from[0];
      const float square = dx * dx + dy * dy;
      if (square < plainSquare) {
        if (fill != 0) row[x] = over(fill, row[x]);
        continue;
      }
      const float distance = std::sqrt(square);
      const unsigned outlined = isOutlined ? shareOf(distance - innerRadius + 0.5f) : 0;
      const QRgb color = scaled(fill, kWhole - outlined) + scaled(outline, outlined);
      row[x] = over(scaled(color, shareOf(reach - distance)), row[x]);
    }
  }
}

/// An upright rectangle: a flat stroke from left to right.
void paintUpright(const Shape& shape, const Canvas& canvas) {
  const float top = shape.from[1] - shape.fromHalfWidth;
  const float bottom = shape.from[1] + shape.fromHalfWidth;
  const float left = shape.from[0];
  const float right = shape.to[0];
  const auto covered = [](int pixel, float low, float high) {
    const auto start = static_cast<float>(pixel);
    return shareOf(std::min(start + 1, high) - std::max(start, low));
  };
  const PixelRange rows = canvas.rows(top - 0.5f, bottom + 0.5f);
  const PixelRange columns = canvas.columns(left - 0.5f, right + 0.5f);
  for (int y = rows.first; y <= rows.last; y += canvas.rowStep()) {
    const QRgb color = scaled(colorOf(shape.color), covered(y, top, bottom));
    QRgb* const row = canvas.row(y);
    const auto paintEdge = [&](int x) {
      row[x] = over(scaled(color, covered(x, left, right)), row[x]);
    };
    if (columns.first <= columns.last) paintEdge(columns.first);
    for (int x = columns.first + 1; x < columns.last; ++x) row[x] = over(color, row[x]);
    if (columns.first < columns.last) paintEdge(columns.last);
  }
}

/// A stroke of some length, asked for its coverage of pixels. Compiled once for each kind of
/// ends, for the question is asked for every pixel.
template <ShapeEnds kEnds>
class Stroke {
 public:
  explicit Stroke(const Shape& shape)
      : m_shape(shape),
        m_dx(shape.to[0] - shape.from[0]),
        m_dy(shape.to[1] - shape.from[1]),
        m_length(lengthOf(m_dx, m_dy)),
        m_reach(std::max(shape.fromHalfWidth, shape.toHalfWidth) + 0.5f),
        m_endReach(m_reach) {
    m_dx /= m_length;
    m_dy /= m_length;
    m_taper = (shape.toHalfWidth - shape.fromHalfWidth) / m_length;
    if (kEnds == ShapeEnds::kJoined)
      m_endReach *= std::max(lengthOf(shape.fromEdge[0], shape.fromEdge[1]),
                             lengthOf(shape.toEdge[0], shape.toEdge[1]));
  }

  void paint(const Canvas& canvas) const {
    const QRgb color = colorOf(m_shape.color);
    const auto [left, right] = std::minmax(m_shape.from[0], m_shape.to[0]);
    const auto [top, bottom] = std::minmax(m_shape.from[1], m_shape.to[1]);
    // In each row the pixels near the axis are looked at, unless it is too level for that.
    const bool isSteep = std::abs(m_dy) > 1e-3f;
    const float slope = isSteep ? m_dx / m_dy : 0;
    const float half = isSteep ? m_reach / std::abs(m_dy) : right - left + m_endReach;
    const PixelRange rows = canvas.rows(top - m_endReach, bottom + m_endReach);
    for (int y = rows.first; y <= rows.last; y += canvas.rowStep()) {
      const float py = static_cast<float>(y) + 0.5f - m_shape.from[1];
      const float middle = m_shape.from[0] + py * slope;
      const PixelRange columns = canvas.columns(std::max(left - m_endReach, middle - half),
                                                std::min(right + m_endReach, middle + half));
      QRgb* const row = canvas.row(y);
      for (int x = columns.first; x <= columns.last; ++x) {
        const unsigned share = coverage(static_cast<float>(x) + 0.5f - m_shape.from[0], py);
        if (share > 0) row[x] = over(scaled(color, share), row[x]);
      }
    }
  }

 private:
  /// @param px, py  from the start of the axis to the pixel's center
  unsigned coverage(float px, float py) const {
    if (kEnds == ShapeEnds::kJoined && !isBetweenEdges(px, py)) return 0;
    const float along = px * m_dx + py * m_dy;
    const float across = std::abs(py * m_dx - px * m_dy);
    const float onAxis = std::clamp(along, 0.0f, m_length);
    const float inside = m_shape.fromHalfWidth + onAxis * m_taper + 0.5f;
    if (kEnds == ShapeEnds::kRound) return shareOf(inside - lengthOf(along - onAxis, across));
    if (kEnds == ShapeEnds::kJoined) return shareOf(inside - across);
    return shareOf(inside - across) * shareOf(along + 0.5f) * shareOf(m_length - along + 0.5f) /
           (kWhole * kWhole);
  }

  // The edge that two joined strokes share belongs to just one of them.
  bool isBetweenEdges(float px, float py) const {
    const float qx = px - (m_shape.to[0] - m_shape.from[0]);
    const float qy = py - (m_shape.to[1] - m_shape.from[1]);
    return px * m_shape.fromEdge[1] - py * m_shape.fromEdge[0] >= 0 &&
           qx * m_shape.toEdge[1] - qy * m_shape.toEdge[0] < 0;
  }

  const Shape& m_shape;
  float m_dx;  // unit vector along the axis
  float m_dy;
  float m_length;
  float m_reach;     // across the axis
  float m_endReach;  // beyond the axis, in any direction
  float m_taper;     // half width gained per length
};

void paintOn(const Canvas& canvas, const Shape& shape) {
  const bool isPoint = shape.from == shape.to;
  switch (static_cast<ShapeEnds>(static_cast<int>(shape.ends))) {
    case ShapeEnds::kJoined:
      if (!isPoint) Stroke<ShapeEnds::kJoined>(shape).paint(canvas);
      return;
    case ShapeEnds::kRound:
      if (isPoint) return paintDisc(shape, canvas);
      return Stroke<ShapeEnds::kRound>(shape).paint(canvas);
    case ShapeEnds::kFlat:
      if (shape.from[1] == shape.to[1] && shape.fromHalfWidth == shape.toHalfWidth)
        return paintUpright(shape, canvas);
      if (!isPoint) Stroke<ShapeEnds::kFlat>(shape).paint(canvas);
      return;
  }
}

}  // namespace

// Every thread paints rows of its own, in turn: so none waits for another, however the shapes lie.
void paintShapes(const std::vector<Shape>& shapes, QImage& image) {
  constexpr std::size_t kFewestForThreads = 2000;  // fewer are painted before a thread has begun
  constexpr unsigned kMostThreads = 4;             // each looks at all shapes
  assert(image.format() == QImage::Format_RGB32);
  const unsigned processors = std::clamp(std::thread::hardware_concurrency(), 1u, kMostThreads);
  const int threads = shapes.size() < kFewestForThreads ? 1 : static_cast<int>(processors);
  const auto paintRowsOf = [&shapes](const Canvas& canvas) {
    for (const Shape& shape : shapes) paintOn(canvas, shape);
  };
  std::vector<std::future<void>> others;
  for (int i = 1; i < threads; ++i)
    others.push_back(std::async(std::launch::async, paintRowsOf, Canvas(image, i, threads)));
  paintRowsOf(Canvas(image, 0, threads));
}

}  // namespace ui
