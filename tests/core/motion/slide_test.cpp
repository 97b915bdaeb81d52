#include "core/motion/slide.h"

#include <cmath>

#include <QtTest>

using core::Slide;
using core::SlideState;

class SlideTest : public QObject {
  Q_OBJECT

 private slots:
  void agreesWithASlopeWorkedByHand();
  void isBrakedWhicheverWayItSlides();
  void keepsThePullOfItsStartPastTheStop();
  void losesWhatAirAndFrictionTake();
};

void SlideTest::agreesWithASlopeWorkedByHand() {
  const Slide slide(/*friction*/ 2, /*way*/ -1, /*mass*/ 0.5, /*drag*/ 0.1);
  const SlideState<> slope = slide(SlideState<>(4, -3, 7));
  // v' = 0.1·3·3 + 2, Q' = 0.5·0.1·3³
  QCOMPARE(slope[0], -3.0);
  QVERIFY(std::abs(slope[1] - 2.9) < 1e-15);
  QVERIFY(std::abs(slope[2] - 1.35) < 1e-15);
}

void SlideTest::isBrakedWhicheverWayItSlides() {
  const SlideState<> right = Slide(3, 1, 1, 0.2)(SlideState<>(0, 2, 0));
  const SlideState<> left = Slide(3, -1, 1, 0.2)(SlideState<>(0, -2, 0));
  QVERIFY(right[1] < -3);
  QCOMPARE(left[1], -right[1]);
  QCOMPARE(left[2], right[2]);
}

void SlideTest::keepsThePullOfItsStartPastTheStop() {
  const Slide slide(3, 1, 1, 0);
  QCOMPARE(slide(SlideState<>(0, 0, 0))[1], -3.0);
  QCOMPARE(slide(SlideState<>(0, -0.1, 0))[1], -3.0);
}

void SlideTest::losesWhatAirAndFrictionTake() {
  const double mass = 0.19, friction = 1.7, v = 2.6;
  const SlideState<> slope = Slide(friction, 1, mass, 0.3)(SlideState<>(0, v, 0));
  // d/dt ½ m v² + Q' + m μ g v = 0
  const double sum = mass * v * slope[1] + slope[2] + mass * friction * v;
  QVERIFY(std::abs(sum) < 1e-14);
}

QTEST_APPLESS_MAIN(SlideTest)
#include "slide_test.moc"
