#include "core/scene/placing.h"

#include <QTest>

#include "core/scene/arrangement.h"
#include "core/scene/scene_limits.h"

namespace {

core::Scene with(core::Scene scene, const std::vector<core::Weight>& more) {
  scene.weights.insert(scene.weights.end(), more.begin(), more.end());
  return scene;
}

}  // namespace

class PlacingTest : public QObject {
  Q_OBJECT

 private slots:
  void leavesWhatOverlapsNothing();
  void copiesOfEveryKindStandBesideTheOthers_data();
  void copiesOfEveryKindStandBesideTheOthers();
  void aFullRoomLeavesThemWhereTheyAre();
  void aHundredThousandWeightsTakeFewTries();
};

void PlacingTest::leavesWhatOverlapsNothing() {
  core::Weight free;
  free.position = {1, 1};
  QVERIFY(core::placedApart(core::withWeightCount(core::Scene(), 3), {free}).front() == free);
}

void PlacingTest::copiesOfEveryKindStandBesideTheOthers_data() {
  QTest::addColumn<int>("first");
  QTest::addColumn<int>("count");
  QTest::newRow("one on a rope") << 0 << 1;
  QTest::newRow("one that is free") << 5 << 1;
  QTest::newRow("all on ropes") << 0 << 5;
  QTest::newRow("all") << 0 << 6;
}

void PlacingTest::copiesOfEveryKindStandBesideTheOthers() {
  QFETCH(int, first);
  QFETCH(int, count);
  core::Scene scene = core::withWeightCount(core::Scene(), 5);
  core::Weight ball;
  ball.radius = 0.3;
  ball.position = {2, 0.5};
  scene.weights.push_back(ball);
  const auto begin = scene.weights.begin() + first;
  const auto copies = core::placedApart(scene, {begin, begin + count});
  const core::Scene both = with(scene, copies);
  QVERIFY(core::problemsIn(both).empty());
  if (count == 6) return;  // there is no way for all: each has its own
  const Eigen::Vector2d way = core::startPosition(copies[0]) - core::startPosition(*begin);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d own = core::startPosition(copies[i]) - core::startPosition(*(begin + i));
    // What is left of a difference of coordinates of some meters.
    QVERIFY((own - way).norm() < 1e-14);
  }
}

void PlacingTest::aFullRoomLeavesThemWhereTheyAre() {
  core::Scene scene;
  core::Weight ball;
  ball.radius = 1.4;
  ball.position = {2, 1.5};
  scene.weights = {ball};
  QVERIFY(core::placedApart(scene, {ball}).front() == ball);
}

void PlacingTest::aHundredThousandWeightsTakeFewTries() {
  core::Scene scene;
  scene.room.width = 400;
  core::Weight ball;
  for (int i = 0; i < core::kMostWeights - 1; ++i) {
    ball.position = {0.1 + 0.1 * (i % 3900), 0.1 + 0.1 * (i / 3900)};
    scene.weights.push_back(ball);
  }
  const auto copies = core::placedApart(scene, {scene.weights[50000]});
  QVERIFY(core::problemsIn(with(scene, copies)).empty());
}

QTEST_GUILESS_MAIN(PlacingTest)
#include "placing_test.moc"
