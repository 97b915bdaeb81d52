#include "core/contact/broad_phase.h"

#include <cmath>
#include <random>
#include <set>

#include <QtTest>

using core::Box;
using core::BroadPhase;
using Eigen::Vector2d;

namespace {

/// Boxes made up by a seed.
class BoxMaker {
 public:
  /// @param decades  the widest is this many powers of ten wider than the narrowest
  BoxMaker(int seed, double decades) : m_random(seed), m_decade(-decades, 0) {}

  Box next() {
    const Vector2d low(m_place(m_random), m_place(m_random));
    return {low,
            low + Vector2d(std::pow(10, m_decade(m_random)), std::pow(10, m_decade(m_random)))};
  }

  std::vector<Box> several(int count) {
    std::vector<Box> boxes(count);
    for (Box& box : boxes) box = next();
    return boxes;
  }

 private:
  std::mt19937 m_random;
  std::uniform_real_distribution<double> m_place{-1, 1};
  std::uniform_real_distribution<double> m_decade;
};

std::vector<int> namedNear(BroadPhase& broadPhase, const Box& box) {
  std::vector<int> named;
  broadPhase.forEachNear(box, [&](int weight) { named.push_back(weight); });
  return named;
}

/// Weights whose boxes meet the box but which the broad phase does not name, and weights it
/// names twice.
int faultsAround(BroadPhase& broadPhase, const std::vector<Box>& boxes, const Box& box) {
  const std::vector<int> named = namedNear(broadPhase, box);
  const std::set<int> once(named.begin(), named.end());
  auto faults = static_cast<int>(named.size() - once.size());
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
    if (boxes[i].meets(box) && !once.contains(i)) ++faults;
  return faults;
}

}  // namespace

class BroadPhaseTest : public QObject {
  Q_OBJECT

 private slots:
  void namesEveryBoxThatMeets_data();
  void namesEveryBoxThatMeets();
  void namesEveryBoxThatMeetsAfterMoves_data();
  void namesEveryBoxThatMeetsAfterMoves();
  void managesBoxesWithoutExtent();
  void managesBoxesOutsideTheRest();
  void namesFewWhereWeightsAreEvenlySpread();
  void namesFewAfterManyMoves();
};

void BroadPhaseTest::namesEveryBoxThatMeets_data() {
  QTest::addColumn<int>("count");
  QTest::addColumn<double>("decades");
  for (const int count : {0, 1, 2, 7, 8, 30, 300})
    for (const double decades : {0.0, 2.0, 6.0})
      QTest::addRow("%d over %g decades", count, decades) << count << decades;
}

void BroadPhaseTest::namesEveryBoxThatMeets() {
  QFETCH(int, count);
  QFETCH(double, decades);
  BoxMaker maker(count, decades);
  const std::vector<Box> boxes = maker.several(count);
  BroadPhase broadPhase(boxes);
  broadPhase.rebuild();
  for (const Box& box : boxes) QCOMPARE(faultsAround(broadPhase, boxes, box), 0);
  for (int i = 0; i < 100; ++i) QCOMPARE(faultsAround(broadPhase, boxes, maker.next()), 0);
}

void BroadPhaseTest::namesEveryBoxThatMeetsAfterMoves_data() {
  namesEveryBoxThatMeets_data();
}

void BroadPhaseTest::namesEveryBoxThatMeetsAfterMoves() {
  QFETCH(int, count);
  QFETCH(double, decades);
  BoxMaker maker(count, decades);
  std::vector<Box> boxes = maker.several(count);
  BroadPhase broadPhase(boxes);
  broadPhase.rebuild();
  for (int i = 0; i < 5 * count; ++i) {
    const int moved = (7 * i + i / count) % count;
    boxes[moved] = maker.next();
    broadPhase.move(moved);
    QCOMPARE(faultsAround(broadPhase, boxes, boxes[moved]), 0);
    QCOMPARE(faultsAround(broadPhase, boxes, maker.next()), 0);
  }
}

void BroadPhaseTest::managesBoxesWithoutExtent() {
  const std::vector<Box> boxes(20, Box{{1, 1}, {1, 1}});
  BroadPhase broadPhase(boxes);
  broadPhase.rebuild();
  QCOMPARE(faultsAround(broadPhase, boxes, boxes[0]), 0);
  QCOMPARE(faultsAround(broadPhase, boxes, {{0, 0}, {2, 2}}), 0);
}

void BroadPhaseTest::managesBoxesOutsideTheRest() {
  std::vector<Box> boxes = BoxMaker(3, 1).several(40);
  BroadPhase broadPhase(boxes);
  broadPhase.rebuild();
  boxes[5] = {{1e6, 1e6}, {1e6 + 1, 1e6 + 1}};
  boxes[6] = {{-1e9, -1e9}, {1e9, 1e9}};
  broadPhase.move(5);
  broadPhase.move(6);
  for (const Box& box : boxes) QCOMPARE(faultsAround(broadPhase, boxes, box), 0);
}

void BroadPhaseTest::namesFewWhereWeightsAreEvenlySpread() {
  std::vector<Box> boxes;
  for (int i = 0; i < 10000; ++i) {
    const Vector2d low(i % 100, i / 100);
    boxes.push_back({low, low + Vector2d(0.8, 0.8)});
  }
  BroadPhase broadPhase(boxes);
  broadPhase.rebuild();
  std::size_t named = 0;
  for (const Box& box : boxes) named += namedNear(broadPhase, box).size();
  // A box lies in at most four cells of its own size, each shared by a few others.
  QVERIFY(named < 16 * boxes.size());
}

void BroadPhaseTest::namesFewAfterManyMoves() {
  std::vector<Box> boxes;
  for (int i = 0; i < 100; ++i) {
    const Vector2d low(i % 10, i / 10);
    boxes.push_back({low, low + Vector2d(0.8, 0.8)});
  }
  BroadPhase broadPhase(boxes);
  broadPhase.rebuild();
  for (int i = 0; i < 100000; ++i) {
    const Vector2d low(i % 11, i % 7);
    boxes[1] = {low, low + Vector2d(0.8, 0.8)};
    broadPhase.move(1);
  }
  QVERIFY(namedNear(broadPhase, boxes[55]).size() < 30);
  QCOMPARE(faultsAround(broadPhase, boxes, boxes[1]), 0);
}

QTEST_APPLESS_MAIN(BroadPhaseTest)
#include "broad_phase_test.moc"
