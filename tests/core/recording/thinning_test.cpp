#include "core/recording/thinning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QtTest>

using core::TimedPoint;

namespace {

/// A wave of uneven spacing with a spike and a notch one point wide.
std::vector<TimedPoint> waveWithSpikes(int count) {
  std::vector<TimedPoint> curve;
  for (int i = 0; i < count; ++i) {
    const double x = std::pow(i, 1.2);
    curve.push_back({x, x, std::sin(x / 50)});
  }
  curve[count / 3].y = 7;
  curve[count / 2].y = -7;
  return curve;
}

struct Extremes {
  double lowest = 100;
  double highest = -100;
};

Extremes extremesBetween(const std::vector<TimedPoint>& curve, double left, double right) {
  Extremes extremes;
  for (const TimedPoint& point : curve) {
    if (point.x < left || point.x > right) continue;
    extremes.lowest = std::min(extremes.lowest, point.y);
    extremes.highest = std::max(extremes.highest, point.y);
  }
  return extremes;
}

}  // namespace

class ThinningTest : public QObject {
  Q_OBJECT

 private slots:
  void leavesAShortCurveAlone();
  void keepsAtMostSoMany_data();
  void keepsAtMostSoMany();
  void keepsEveryPeakOfEveryPart();
  void neverKeepsAPointTwice();
  void keepsWhereACurveTurnsBack();
  void copesWithOneMoment();
};

void ThinningTest::leavesAShortCurveAlone() {
  const std::vector<TimedPoint> curve = waveWithSpikes(50);
  QVERIFY(core::thinned(curve, 50) == curve);
  QVERIFY(core::thinned({}, 12).empty());
}

void ThinningTest::keepsAtMostSoMany_data() {
  QTest::addColumn<int>("most");
  for (const int most : {12, 17, 100, 1999}) QTest::addRow("%d", most) << most;
}

void ThinningTest::keepsAtMostSoMany() {
  QFETCH(int, most);
  const std::vector<TimedPoint> curve = waveWithSpikes(2000);
  const std::vector<TimedPoint> few = core::thinned(curve, most);
  QVERIFY(static_cast<int>(few.size()) <= most);
  QVERIFY(static_cast<int>(few.size()) > most / 6);
  QCOMPARE(few.front(), curve.front());
  QCOMPARE(few.back(), curve.back());
  // Each point is one of the curve's, and they come in its order.
  auto from = curve.begin();
  for (const TimedPoint& point : few) {
    from = std::find(from, curve.end(), point);
    QVERIFY(from != curve.end());
    ++from;
  }
}

void ThinningTest::keepsEveryPeakOfEveryPart() {
  const std::vector<TimedPoint> curve = waveWithSpikes(3000);
  const std::vector<TimedPoint> few = core::thinned(curve, 60);
  const double width = curve.back().x / 10;
  for (int part = 0; part < 10; ++part) {
    // Its ends may be rounded: what lies on them may have gone to the neighbor.
    const Extremes all = extremesBetween(curve, part * width + 1e-6, (part + 1) * width - 1e-6);
    const Extremes kept = extremesBetween(few, part * width - 1e-6, (part + 1) * width + 1e-6);
    QVERIFY(kept.lowest <= all.lowest);
    QVERIFY(kept.highest >= all.highest);
  }
}

void ThinningTest::neverKeepsAPointTwice() {
  std::vector<TimedPoint> curve;
  for (int i = 0; i < 100; ++i) curve.push_back({double(i), double(i), double(i)});
  // A rising curve: first is lowest and last is highest in each of the two parts.
  QCOMPARE(core::thinned(curve, 12).size(), std::size_t{4});
}

void ThinningTest::keepsWhereACurveTurnsBack() {
  // Around a circle in 1000 points: of each half its outermost places.
  constexpr int kCount = 1000;
  std::vector<TimedPoint> circle;
  for (int i = 0; i < kCount; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCount;
    circle.push_back({double(i), std::cos(angle), std::sin(angle)});
  }
  const auto few = core::thinned(circle, 12);
  for (const int outermost : {0, kCount / 4, kCount / 2, 3 * kCount / 4}) {
    QVERIFY(std::ranges::count(few, circle[outermost]) == 1);
  }
  QVERIFY(few.size() <= 12);
}

void ThinningTest::copesWithOneMoment() {
  std::vector<TimedPoint> curve(100, TimedPoint{3, 3, 1});
  curve[40].y = 5;
  curve[60].y = -5;
  const std::vector<TimedPoint> few = core::thinned(curve, 12);
  QVERIFY(few == (std::vector<TimedPoint>{{3, 3, 1}, {3, 3, 5}, {3, 3, -5}, {3, 3, 1}}));
}

QTEST_APPLESS_MAIN(ThinningTest)
#include "thinning_test.moc"
