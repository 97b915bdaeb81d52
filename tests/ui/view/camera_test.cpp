#include "ui/view/camera.h"

#include <cmath>

#include <QTest>

// Pixels are compared to a billionth: rounding errors of a few operations on numbers up to 10^5.
constexpr double kRounding = 1e-9;

class CameraTest : public QObject {
  Q_OBJECT

 private slots:
  void fitShowsTheWholeRoomWithinItsMargins_data();
  void fitShowsTheWholeRoomWithinItsMargins();
  void turnsPixelsBackIntoTheSameMetres();
  void drawsHigherThingsFurtherUp();
  void zoomKeepsThePlaceUnderThePointer();
  void zoomEndsAtItsLimits();
  void panMovesThePictureByThePixels();
  void panNeverLosesTheRoom();
  void anotherWindowSizeKeepsCenterAndScale();
  void snapsToEdgesBetweenDevicePixels_data();
  void snapsToEdgesBetweenDevicePixels();

 private:
  static ui::Camera fitted() {
    ui::Camera camera;
    camera.setViewport({800, 600});
    camera.fit({4, 3}, {80, 40, 20, 60});
    return camera;
  }
};

void CameraTest::fitShowsTheWholeRoomWithinItsMargins_data() {
  QTest::addColumn<QSizeF>("room");
  QTest::addColumn<QSizeF>("viewport");
  QTest::newRow("classroom") << QSizeF(4, 3) << QSizeF(800, 600);
  QTest::newRow("tall") << QSizeF(1, 50) << QSizeF(800, 600);
  QTest::newRow("wide") << QSizeF(50, 1) << QSizeF(800, 600);
  QTest::newRow("smallest") << QSizeF(0.01, 0.01) << QSizeF(1920, 1080);
  QTest::newRow("largest") << QSizeF(1e5, 1e5) << QSizeF(1920, 1080);
  QTest::newRow("mixed") << QSizeF(1e5, 0.01) << QSizeF(300, 900);
}

void CameraTest::fitShowsTheWholeRoomWithinItsMargins() {
  QFETCH(QSizeF, room);
  QFETCH(QSizeF, viewport);
  const QMarginsF margins(80, 40, 20, 60);
  ui::Camera camera;
  camera.setViewport(viewport);
  camera.fit(room, margins);

  const QRectF inside(camera.toPixels({0, room.height()}), camera.toPixels({room.width(), 0}));
  const QRectF allowed = QRectF(QPointF(0, 0), viewport).marginsRemoved(margins);
  QVERIFY(allowed.adjusted(-kRounding, -kRounding, kRounding, kRounding).contains(inside));
  // As large as it goes: it fills the allowed part in one direction, and stands in its middle.
  QVERIFY(std::abs(inside.width() - allowed.width()) < kRounding ||
          std::abs(inside.height() - allowed.height()) < kRounding);
  QVERIFY(QLineF(inside.center(), allowed.center()).length() < kRounding);
}

void CameraTest::turnsPixelsBackIntoTheSameMetres() {
  const ui::Camera camera = fitted();
  const Eigen::Vector2d place(1.234, 2.345);
  QVERIFY((camera.toMetres(camera.toPixels(place)) - place).norm() < kRounding);
}

void CameraTest::drawsHigherThingsFurtherUp() {
  const ui::Camera camera = fitted();
  QVERIFY(camera.toPixels({1, 2}).y() < camera.toPixels({1, 1}).y());
  QVERIFY(camera.toPixels({2, 1}).x() > camera.toPixels({1, 1}).x());
}

void CameraTest::zoomKeepsThePlaceUnderThePointer() {
  ui::Camera camera = fitted();
  const QPointF pointer(310, 270);
  const Eigen::Vector2d before = camera.toMetres(pointer);
  const double scale = camera.scale();
  camera.zoomAt(pointer, 3);
  QCOMPARE(camera.scale(), 3 * scale);
  QVERIFY((camera.toMetres(pointer) - before).norm() < kRounding);
}

void CameraTest::zoomEndsAtItsLimits() {
  ui::Camera camera = fitted();
  const double fittedScale = camera.scale();
  for (int i = 0; i < 100; ++i) camera.zoomAt({300, 200}, 0.5);
  QCOMPARE(camera.scale(), fittedScale * ui::Camera::kSmallestShare);
  for (int i = 0; i < 100; ++i) camera.zoomAt({300, 200}, 2);
  QCOMPARE(camera.scale(), ui::Camera::kLargestScale);
}

void CameraTest::panMovesThePictureByThePixels() {
  ui::Camera camera = fitted();
  const QPointF before = camera.toPixels({1, 1});
  camera.panBy({30, -20});
  QVERIFY(QLineF(camera.toPixels({1, 1}), before + QPointF(30, -20)).length() < kRounding);
}

void CameraTest::panNeverLosesTheRoom() {
  ui::Camera camera = fitted();
  camera.panBy({1e6, -1e6});
  const Eigen::Vector2d center = camera.toMetres({400, 300});
  QVERIFY((center - Eigen::Vector2d(0, 0)).norm() < kRounding);
}

void CameraTest::anotherWindowSizeKeepsCenterAndScale() {
  ui::Camera camera = fitted();
  const double scale = camera.scale();
  const Eigen::Vector2d center = camera.toMetres({400, 300});
  camera.setViewport({500, 400});
  QCOMPARE(camera.scale(), scale);
  QVERIFY((camera.toMetres({250, 200}) - center).norm() < kRounding);
}

void CameraTest::snapsToEdgesBetweenDevicePixels_data() {
  QTest::addColumn<double>("ratio");
  QTest::newRow("1") << 1.0;
  QTest::newRow("1.5") << 1.5;
  QTest::newRow("2") << 2.0;
}

void CameraTest::snapsToEdgesBetweenDevicePixels() {
  QFETCH(double, ratio);
  ui::Camera camera = fitted();
  camera.setViewport({800, 600}, ratio);
  const double snapped = camera.snapped(123.4);
  QVERIFY(std::abs(snapped - 123.4) <= 0.5 / ratio);
  QVERIFY(std::abs(snapped * ratio - std::round(snapped * ratio)) < kRounding);
}

QTEST_GUILESS_MAIN(CameraTest)
#include "camera_test.moc"
