#include "core/scene/arrangement.h"

#include <cmath>
#include <set>
#include <tuple>

#include <QtTest>

#include "core/scene/angle.h"
#include "core/scene/scene_limits.h"

using core::Color;
using core::Scene;

namespace {

/// Weights on ropes of 1 m, all drawn aside by `angle`.
Scene pendulums(int count, double angleInDegrees) {
  Scene scene;
  scene.weights.resize(count);
  for (core::Weight& weight : scene.weights) {
    weight.rope = core::Rope{{2, 2.8}, 1, core::radians(angleInDegrees), 0, false};
  }
  return core::withWeightCount(scene, count);
}

std::vector<double> pivots(const Scene& scene) {
  std::vector<double> x;
  for (const core::Weight& weight : scene.weights) {
    if (weight.rope) x.push_back(weight.rope->pivot.x());
  }
  return x;
}

// Room widths are a few meters: a few roundings of such numbers.
constexpr double kRounding = 1e-12;

bool areEvenlySpaced(const std::vector<double>& x) {
  for (std::size_t i = 2; i < x.size(); ++i) {
    if (std::abs((x[i] - x[i - 1]) - (x[1] - x[0])) > kRounding) return false;
  }
  return x.size() < 2 || x[1] > x[0];
}

}  // namespace

class ArrangementTest : public QObject {
  Q_OBJECT

 private slots:
  void everyEarlyColorIsDistinct();
  void laterColorsAreSeenOnLightAndDark();
  void colorsStayTheSame();
  void aWeightsOwnColorWins();
  void hangsThemEvenlyAcrossTheRoom_data();
  void hangsThemEvenlyAcrossTheRoom();
  void changesTheNumberBackAndForth();
  void keepsTheirSwingsBetweenTheWalls();
  void usesTheWholeRoomWhereSwingsLeaveTooLittle();
  void keepsThemInOrderAndAtOneHeight();
  void copiesTheLastButNotItsColor();
  void setsFreeCopiesBesideTheLast();
  void leavesFreeWeightsWhereTheyAre();
  void beginsWithAWeightOnARope_data();
  void beginsWithAWeightOnARope();
  void leavesACrowdForTheUserToSolve();
};

void ArrangementTest::everyEarlyColorIsDistinct() {
  std::set<std::tuple<int, int, int>> colors;
  for (int i = 0; i < 8; ++i) {
    const Color color = core::defaultColor(i);
    colors.insert({color.red, color.green, color.blue});
  }
  QCOMPARE(colors.size(), std::size_t{8});
  QCOMPARE(core::defaultColor(0), (Color{0xe6, 0x9f, 0x00}));
}

void ArrangementTest::laterColorsAreSeenOnLightAndDark() {
  for (int i = 8; i < 5000; ++i) {
    const Color color = core::defaultColor(i);
    const int most = std::max({color.red, color.green, color.blue});
    const int least = std::min({color.red, color.green, color.blue});
    QVERIFY(most >= 150);
    QVERIFY(least <= 110);
  }
}

void ArrangementTest::colorsStayTheSame() {
  // Lessons and pictures name weights by color: these must never change.
  QCOMPARE(core::defaultColor(8), (Color{145, 56, 213}));
  QCOMPARE(core::defaultColor(1000), (Color{178, 70, 148}));
}

void ArrangementTest::aWeightsOwnColorWins() {
  Scene scene = pendulums(3, 0);
  scene.weights[1].color = Color{1, 2, 3};
  QCOMPARE(core::colorOf(scene, 1), (Color{1, 2, 3}));
  QCOMPARE(core::colorOf(scene, 2), core::defaultColor(2));
}

void ArrangementTest::hangsThemEvenlyAcrossTheRoom_data() {
  QTest::addColumn<int>("count");
  for (const int count : {1, 2, 3, 7, 9, 50, 99}) QTest::addRow("%d", count) << count;
}

void ArrangementTest::hangsThemEvenlyAcrossTheRoom() {
  QFETCH(int, count);
  const Scene scene = core::withWeightCount(pendulums(4, 0), count);
  const std::vector<double> x = pivots(scene);
  QCOMPARE(static_cast<int>(x.size()), count);
  QVERIFY(areEvenlySpaced(x));
  // Hanging straight down each stands in the middle of its part of the 4 m.
  QVERIFY(std::abs(x.front() - 2.0 / count) < kRounding);
  QVERIFY(std::abs(x.back() - (4 - 2.0 / count)) < kRounding);
  QVERIFY(core::problemsIn(scene).empty());
}

void ArrangementTest::changesTheNumberBackAndForth() {
  const Scene seven = pendulums(7, 60);
  const Scene nine = core::withWeightCount(seven, 9);
  QVERIFY(areEvenlySpaced(pivots(nine)));
  QVERIFY(core::problemsIn(nine).empty());
  const std::vector<double> again = pivots(core::withWeightCount(nine, 7));
  QCOMPARE(again, pivots(seven));
}

void ArrangementTest::keepsTheirSwingsBetweenTheWalls() {
  const std::vector<double> x = pivots(pendulums(7, -60));
  const double reach = std::sqrt(0.75) + 0.02;
  QVERIFY(areEvenlySpaced(x));
  QVERIFY(std::abs(x.front() - reach) < kRounding);
  QVERIFY(std::abs(x.back() - (4 - reach)) < kRounding);
}

void ArrangementTest::usesTheWholeRoomWhereSwingsLeaveTooLittle() {
  // Swings of 60° leave the pivots a stretch of 2.2 m, but 70 weights are 2.8 m wide.
  const Scene scene = pendulums(70, 60);
  QVERIFY(areEvenlySpaced(pivots(scene)));
  QVERIFY(core::problemsIn(scene).empty());

  // A rope longer than the room is wide starts between the walls all the same.
  Scene narrow = pendulums(1, 50);
  narrow.room.width = 1;
  narrow = core::withWeightCount(narrow, 5);
  QVERIFY(core::problemsIn(narrow).empty());
}

void ArrangementTest::keepsThemInOrderAndAtOneHeight() {
  Scene scene = pendulums(3, 10);
  for (int i = 0; i < 3; ++i) {
    scene.weights[i].mass = 1 + i;
    scene.weights[i].rope->pivot.y() = 2.5 - 0.1 * i;
  }
  scene = core::withWeightCount(scene, 3);
  QVERIFY(areEvenlySpaced(pivots(scene)));
  for (int i = 0; i < 3; ++i) {
    QCOMPARE(scene.weights[i].mass, 1.0 + i);
    QCOMPARE(scene.weights[i].rope->pivot.y(), 2.5);
  }
}

void ArrangementTest::copiesTheLastButNotItsColor() {
  Scene scene = pendulums(2, 20);
  scene.weights[0].color = Color{9, 9, 9};
  scene.weights[1].color = Color{1, 2, 3};
  scene.weights[1].mass = 5;
  scene.weights[1].rope->length = 0.7;
  scene = core::withWeightCount(scene, 4);
  QCOMPARE(scene.weights[3].mass, 5.0);
  QCOMPARE(scene.weights[3].rope->length, 0.7);
  QCOMPARE(core::colorOf(scene, 0), (Color{9, 9, 9}));
  QCOMPARE(core::colorOf(scene, 1), (Color{1, 2, 3}));
  QCOMPARE(core::colorOf(scene, 3), core::defaultColor(3));
}

void ArrangementTest::setsFreeCopiesBesideTheLast() {
  Scene scene;
  scene.weights.resize(1);
  scene.weights[0].position = {2, 1};
  scene.weights[0].velocity = {1, -1};
  scene = core::withWeightCount(scene, 40);
  QCOMPARE(scene.weights.size(), std::size_t{40});
  QCOMPARE(scene.weights[39].velocity, Eigen::Vector2d(1, -1));
  QVERIFY(core::problemsIn(scene).empty());
}

void ArrangementTest::leavesFreeWeightsWhereTheyAre() {
  Scene scene = pendulums(3, 0);
  scene.weights[1].rope.reset();
  scene.weights[1].position = {0.3, 0.4};
  scene = core::withWeightCount(scene, 5);
  QCOMPARE(scene.weights[1].position, Eigen::Vector2d(0.3, 0.4));
  QCOMPARE(pivots(scene).size(), std::size_t{4});
  QVERIFY(areEvenlySpaced(pivots(scene)));
}

void ArrangementTest::beginsWithAWeightOnARope_data() {
  QTest::addColumn<double>("width");
  QTest::addColumn<double>("height");
  QTest::newRow("a hall") << 100.0 << 20.0;
  QTest::newRow("a room") << 4.0 << 3.0;
  QTest::newRow("a box") << 0.5 << 0.3;
}

void ArrangementTest::beginsWithAWeightOnARope() {
  QFETCH(double, width);
  QFETCH(double, height);
  Scene scene;
  scene.room.width = width;
  scene.room.height = height;
  scene = core::withWeightCount(scene, 3);
  QCOMPARE(pivots(scene).size(), std::size_t{3});
  QVERIFY(core::problemsIn(scene).empty());
  QVERIFY(core::withWeightCount(scene, 0).weights.empty());
}

void ArrangementTest::leavesACrowdForTheUserToSolve() {
  const Scene scene = core::withWeightCount(pendulums(7, 0), 1000);
  QCOMPARE(scene.weights.size(), std::size_t{1000});
  QVERIFY(areEvenlySpaced(pivots(scene)));
  const auto problems = core::problemsIn(scene);
  QCOMPARE(problems.size(), std::size_t{999});
  QCOMPARE(problems[0].kind, core::Problem::Kind::kOverlap);
}

QTEST_APPLESS_MAIN(ArrangementTest)
#include "arrangement_test.moc"
