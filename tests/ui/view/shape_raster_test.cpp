#include "ui/view/shape_raster.h"

#include <cmath>
#include <numbers>

#include <QImage>
#include <QTest>

#include "ui/view/camera.h"
#include "ui/view/drawing.h"
#include "ui/view/shape.h"

namespace {

QImage black(int width = 64, int height = 64) {
  QImage image(width, height, QImage::Format_RGB32);
  image.fill(Qt::black);
  return image;
}

/// Sum of a channel over all pixels, in whole pixels: the area of something white on black.
double paintedArea(const QImage& image) {
  double area = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) area += qGreen(image.pixel(x, y)) / 255.0;
  return area;
}

constexpr QRgb kWhite = 0xffffffff;

}  // namespace

class ShapeRasterTest : public QObject {
  Q_OBJECT

 private slots:
  void discsCoverTheirAreaWhereverTheyLie_data();
  void discsCoverTheirAreaWhereverTheyLie();
  void discsStandAtTheirExactPlace();
  void outlinesLieInsideTheEdge();
  void ringsLeaveTheirInsideAlone();
  void strokesCoverTheirArea_data();
  void strokesCoverTheirArea();
  void joinedStrokesNeitherOverlapNorLeaveGaps();
  void uprightRectanglesFillWholePixels();
  void partOfARectanglesPixelIsPartlyCovered();
  void shapesOutsideOfTheImagePaintNothing();
  void keepsTheImageOpaque();
  void paintsManyShapesToTheSamePixels();
};

void ShapeRasterTest::discsCoverTheirAreaWhereverTheyLie_data() {
  QTest::addColumn<double>("radius");
  QTest::addColumn<double>("offset");
  for (const double radius : {1.0, 3.0, 6.3, 20.0})
    for (const double offset : {0.0, 0.25, 0.5, 0.8})
      QTest::addRow("radius %g, offset %g", radius, offset) << radius << offset;
}

void ShapeRasterTest::discsCoverTheirAreaWhereverTheyLie() {
  QFETCH(double, radius);
  QFETCH(double, offset);
  QImage image = black();
  ui::paintShapes({ui::discShape({32 + offset, 32 - offset}, radius, 0, kWhite, 0)}, image);
  // The soft edge is linear in the distance, and colors have 255 steps: 3 % at one pixel.
  const double exact = std::numbers::pi * radius * radius;
  QVERIFY2(std::abs(paintedArea(image) / exact - 1) < 0.08 / radius,
           qPrintable(QString::number(paintedArea(image) / exact)));
}

void ShapeRasterTest::discsStandAtTheirExactPlace() {
  QImage image = black();
  ui::paintShapes({ui::discShape({30.3, 40.6}, 5, 0, kWhite, 0)}, image);
  double x = 0;
  double y = 0;
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < 64; ++column) {
      const double share = qGreen(image.pixel(column, row)) / 255.0;
      x += share * (column + 0.5);
      y += share * (row + 0.5);
    }
  // A hundredth of a pixel: motion must not step from pixel to pixel.
  QVERIFY(std::abs(x / paintedArea(image) - 30.3) < 0.01);
  QVERIFY(std::abs(y / paintedArea(image) - 40.6) < 0.01);
}

void ShapeRasterTest::outlinesLieInsideTheEdge() {
  QImage image = black();
  ui::paintShapes({ui::discShape({32, 32}, 20, 4, 0xffff0000, 0xff0000ff)}, image);
  QCOMPARE(image.pixel(32, 32), qRgb(255, 0, 0));
  QCOMPARE(image.pixel(32 + 14, 32), qRgb(255, 0, 0));
  QCOMPARE(image.pixel(32 + 17, 32), qRgb(0, 0, 255));
  QCOMPARE(image.pixel(32 + 21, 32), qRgb(0, 0, 0));
}

void ShapeRasterTest::ringsLeaveTheirInsideAlone() {
  QImage image = black();
  image.fill(0xff123456);
  ui::paintShapes({ui::discShape({32, 32}, 20, 3, 0, kWhite)}, image);
  QCOMPARE(image.pixel(32, 32), 0xff123456);
  QCOMPARE(image.pixel(32 + 18, 32), kWhite);
}

void ShapeRasterTest::strokesCoverTheirArea_data() {
  QTest::addColumn<QPointF>("to");
  QTest::addColumn<double>("width");
  QTest::addColumn<int>("ends");
  const auto row = [](const char* name, QPointF to, double width, ui::ShapeEnds ends) {
    QTest::newRow(name) << to << width << static_cast<int>(ends);
  };
  row("level", {50, 10}, 3, ui::ShapeEnds::kRound);
  row("steep", {10, 50}, 3, ui::ShapeEnds::kRound);
  row("slanting", {50, 34}, 2, ui::ShapeEnds::kRound);
  row("back and up", {3, 2}, 2, ui::ShapeEnds::kRound);
  row("slanting, flat", {50, 34}, 4, ui::ShapeEnds::kFlat);
  row("slanting, joined", {50, 34}, 4, ui::ShapeEnds::kJoined);
}

void ShapeRasterTest::strokesCoverTheirArea() {
  QFETCH(QPointF, to);
  QFETCH(double, width);
  QFETCH(int, ends);
  QImage image = black();
  const QPointF from(10, 10);
  ui::paintShapes({ui::strokeShape(from, to, width, kWhite, static_cast<ui::ShapeEnds>(ends))},
                  image);
  const double caps = static_cast<ui::ShapeEnds>(ends) == ui::ShapeEnds::kRound
                          ? std::numbers::pi * width * width / 4
                          : 0;
  const double exact = QLineF(from, to).length() * width + caps;
  // As for discs; hard ends of joined strokes round to whole pixels besides.
  QVERIFY2(std::abs(paintedArea(image) / exact - 1) < 0.03,
           qPrintable(QString::number(paintedArea(image) / exact)));
}

void ShapeRasterTest::joinedStrokesNeitherOverlapNorLeaveGaps() {
  ui::Camera camera;
  camera.setViewport({64, 64});
  camera.fit({64, 64}, {});
  ui::Layer layer;
  // A bow of many pieces, half transparent: where two overlap it would be brighter.
  ui::Polyline bow{{}, 8, 0x80ffffff, false};
  for (int i = 0; i <= 24; ++i) {
    const double angle = i * std::numbers::pi / 24;
    bow.points.push_back({32 + 24 * std::cos(angle), 20 + 24 * std::sin(angle)});
  }
  layer.polylines.push_back(bow);
  std::vector<ui::Shape> shapes;
  ui::addShapes(layer, camera, shapes);
  QImage image = black();
  ui::paintShapes(shapes, image);

  for (int i = 1; i < 240; ++i) {
    const double angle = i * std::numbers::pi / 240;
    const QRgb pixel = image.pixel(static_cast<int>(32 + 24 * std::cos(angle)),
                                   static_cast<int>(64 - (20 + 24 * std::sin(angle))));
    // 128 of 255, give or take rounding twice.
    QVERIFY2(std::abs(qGreen(pixel) - 128) <= 2, qPrintable(QString::number(qGreen(pixel))));
  }
}

void ShapeRasterTest::uprightRectanglesFillWholePixels() {
  QImage image = black();
  ui::paintShapes({ui::strokeShape({10, 20}, {30, 20}, 10, kWhite, ui::ShapeEnds::kFlat)}, image);
  QCOMPARE(paintedArea(image), 200.0);
  QCOMPARE(image.pixel(10, 15), kWhite);
  QCOMPARE(image.pixel(29, 24), kWhite);
}

void ShapeRasterTest::partOfARectanglesPixelIsPartlyCovered() {
  QImage image = black();
  ui::paintShapes({ui::strokeShape({10.5, 20}, {30, 20}, 11, kWhite, ui::ShapeEnds::kFlat)}, image);
  // 19.5 × 11; each half covered pixel rounds by up to a 256th, and 60 of them lie at its rim.
  QVERIFY(std::abs(paintedArea(image) - 19.5 * 11) < 60.0 / 256);
}

void ShapeRasterTest::shapesOutsideOfTheImagePaintNothing() {
  QImage image = black();
  for (const double far : {-40.0, 120.0, 1e6}) {
    ui::paintShapes({ui::discShape({far, 20}, 10, 1, kWhite, kWhite)}, image);
    ui::paintShapes({ui::discShape({20, far}, 10, 1, kWhite, kWhite)}, image);
    for (const auto ends : {ui::ShapeEnds::kFlat, ui::ShapeEnds::kJoined, ui::ShapeEnds::kRound}) {
      ui::paintShapes({ui::strokeShape({far, far}, {far + 9, far}, 5, kWhite, ends)}, image);
      ui::paintShapes({ui::strokeShape({20, far}, {30, far + 5}, 5, kWhite, ends)}, image);
    }
  }
  QCOMPARE(paintedArea(image), 0.0);
}

void ShapeRasterTest::keepsTheImageOpaque() {
  QImage image = black();
  ui::paintShapes({ui::discShape({32, 32}, 20, 2, 0x40ff0000, 0x8000ff00)}, image);
  for (int x = 0; x < 64; ++x)
    QVERIFY(qAlpha(reinterpret_cast<const QRgb*>(image.constScanLine(32))[x]) == 255);
}

void ShapeRasterTest::paintsManyShapesToTheSamePixels() {
  std::vector<ui::Shape> shapes;
  for (int i = 0; i < 5000; ++i) {
    const QPointF place(i * 7 % 101, i * 13 % 103);
    shapes.push_back(ui::discShape(place, 1 + i % 9, i % 3, 0xc0204080 + i, 0xff000000));
    shapes.push_back(ui::strokeShape(place, place + QPointF(i % 11, i % 5), 2, 0x80ff0000,
                                     static_cast<ui::ShapeEnds>(i % 3)));
  }
  QImage all(97, 89, QImage::Format_RGB32);
  all.fill(kWhite);
  QImage oneByOne = all;
  ui::paintShapes(shapes, all);
  for (const ui::Shape& shape : shapes) ui::paintShapes({shape}, oneByOne);
  QCOMPARE(all, oneByOne);
}

QTEST_GUILESS_MAIN(ShapeRasterTest)
#include "shape_raster_test.moc"
