#include "ui/view/trails.h"

#include <QTest>

class TrailsTest : public QObject {
  Q_OBJECT

 private slots:
  void showsTheWayInTheOrderItWasGone();
  void tellsRunsAndWeightsApart();
  void forgetsWhatIsLongAgo();
  void followsEveryFrameHoweverSlowTheMotion();
  void staysBoundedForAnyNumberOfWeights_data();
  void staysBoundedForAnyNumberOfWeights();
  void endsWhereTimeGoesBackTo();
  void startsAnewAfterAJumpAhead();
  void reachesBackAsLongAsAFallTakes();

 private:
  /// Runs whose weight i of run r is at (time, 10 r + i).
  static std::vector<ui::ShownRun> runsAt(double time, int runCount, int weightCount) {
    std::vector<ui::ShownRun> runs(runCount);
    for (int r = 0; r < runCount; ++r)
      for (int i = 0; i < weightCount; ++i) {
        runs[r].weights.emplace_back();
        runs[r].weights.back().position = {time, 10.0 * r + i};
      }
    return runs;
  }

  static ui::Trails recorded(double span, double frame, int frameCount) {
    ui::Trails trails;
    trails.reset(1, 1, span);
    for (int i = 0; i <= frameCount; ++i) trails.record(i * frame, runsAt(i * frame, 1, 1));
    return trails;
  }
};

void TrailsTest::showsTheWayInTheOrderItWasGone() {
  const auto points = recorded(2, 1.0 / 60, 30).points(0, 0);
  QCOMPARE(points.size(), std::size_t(31));
  QCOMPARE(points.front().x(), 0.0);
  QCOMPARE(points.back().x(), 0.5);
  for (std::size_t i = 1; i < points.size(); ++i) QVERIFY(points[i - 1].x() < points[i].x());
}

void TrailsTest::tellsRunsAndWeightsApart() {
  ui::Trails trails;
  trails.reset(2, 3, 2);
  for (const double time : {0.0, 0.1, 0.2}) trails.record(time, runsAt(time, 2, 3));
  for (int r = 0; r < 2; ++r)
    for (int i = 0; i < 3; ++i)
      QCOMPARE(trails.points(r, i).back(), Eigen::Vector2d(0.2, 10 * r + i));
}

void TrailsTest::forgetsWhatIsLongAgo() {
  const auto points = recorded(2, 1.0 / 60, 600).points(0, 0);
  QVERIFY(points.front().x() >= 8 - 1e-9);
  QVERIFY(points.front().x() < 8.1);
  QCOMPARE(points.back().x(), 10.0);
}

void TrailsTest::followsEveryFrameHoweverSlowTheMotion() {
  // Slow motion, 1/64: frames lie much closer than the points that trails can keep.
  const auto points = recorded(2, 1.0 / 60 / 64, 64 * 60 * 3).points(0, 0);
  QCOMPARE(points.back().x(), 3.0);
  QVERIFY(points.front().x() < 1.1);
  QVERIFY(points.size() <= std::size_t(ui::Trails::kMostPointsEach));
}

void TrailsTest::staysBoundedForAnyNumberOfWeights_data() {
  QTest::addColumn<int>("runCount");
  QTest::addColumn<int>("weightCount");
  QTest::newRow("none") << 1 << 0;
  QTest::newRow("seven, twice") << 2 << 7;
  QTest::newRow("a thousand") << 1 << 1000;
  QTest::newRow("the most, four times") << 4 << 100000;
}

void TrailsTest::staysBoundedForAnyNumberOfWeights() {
  QFETCH(int, runCount);
  QFETCH(int, weightCount);
  ui::Trails trails;
  trails.reset(runCount, weightCount, 2);
  QVERIFY(trails.pointsEach() * runCount * weightCount <= ui::Trails::kMostPoints);
  QVERIFY(trails.pointsEach() == 0 || trails.pointsEach() >= ui::Trails::kFewestPointsEach);
  for (int i = 0; i < 3; ++i) trails.record(i, runsAt(i, runCount, weightCount));
  if (trails.pointsEach() == 0) QVERIFY(trails.points(0, 0).empty());
}

void TrailsTest::endsWhereTimeGoesBackTo() {
  ui::Trails trails = recorded(2, 1.0 / 60, 60);
  trails.record(0.51, runsAt(0.51, 1, 1));
  const auto points = trails.points(0, 0);
  QCOMPARE(points.size(), std::size_t(32));  // 0 to 30/60 s, and now
  QCOMPARE(points.front().x(), 0.0);
  QCOMPARE(points.back().x(), 0.51);
  for (std::size_t i = 1; i < points.size(); ++i) QVERIFY(points[i - 1].x() < points[i].x());
  trails.record(-1, runsAt(-1, 1, 1));
  QVERIFY(trails.points(0, 0).empty());
}

void TrailsTest::startsAnewAfterAJumpAhead() {
  ui::Trails trails = recorded(2, 1.0 / 60, 60);
  trails.record(1.4, runsAt(1.4, 1, 1));
  QCOMPARE(trails.points(0, 0).back().x(), 1.4);
  trails.record(2.0, runsAt(2.0, 1, 1));
  QVERIFY(trails.points(0, 0).empty());
}

void TrailsTest::reachesBackAsLongAsAFallTakes() {
  core::Scene scene;
  scene.room.height = 5;
  const double span = ui::trailSpan(scene);
  scene.room.height = 500;
  QCOMPARE(ui::trailSpan(scene), 10 * span);
  scene.gravity = 0;
  QVERIFY(ui::trailSpan(scene) > 0);
}

QTEST_GUILESS_MAIN(TrailsTest)
#include "trails_test.moc"
