#include "core/scene/overlaps.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <QtTest>

using core::Disc;
using core::Overlap;

namespace {

bool reallyOverlap(const Disc& a, const Disc& b) {
  return (a.center - b.center).norm() < (a.radius + b.radius) * (1 - core::kTouchTolerance);
}

/// Discs strewn evenly over a square, their radii evenly over several powers of ten.
std::vector<Disc> strewn(int count, double side, double smallest, double largest) {
  std::vector<Disc> discs;
  for (int i = 0; i < count; ++i) {
    const auto part = [i](double stride) { return std::fmod(stride * i, 1.0); };
    const double radius = smallest * std::pow(largest / smallest, part(std::numbers::egamma));
    discs.push_back({{side * part(std::numbers::sqrt2), side * part(std::numbers::sqrt3)}, radius});
  }
  return discs;
}

}  // namespace

class OverlapsTest : public QObject {
  Q_OBJECT

 private slots:
  void findsEveryOverlap_data();
  void findsEveryOverlap();
  void namesTheLaterOfTwoAlike();
  void namesTheSmallerOfTwo();
  void touchingIsNoOverlap_data();
  void touchingIsNoOverlap();
  void leavesOutWhatIsNoDisc();
  void namesAllButOneOfAHeap();
  void copesWithAHundredThousand_data();
  void copesWithAHundredThousand();
};

void OverlapsTest::findsEveryOverlap_data() {
  QTest::addColumn<double>("side");
  QTest::addColumn<double>("smallest");
  QTest::addColumn<double>("largest");
  QTest::newRow("alike") << 2.5 << 0.05 << 0.05;
  QTest::newRow("mixed") << 50.0 << 0.001 << 2.0;
  QTest::newRow("all allowed radii") << 2e3 << 1e-4 << 100.0;
  QTest::newRow("crowded") << 2.0 << 0.01 << 0.1;
}

void OverlapsTest::findsEveryOverlap() {
  QFETCH(double, side);
  QFETCH(double, smallest);
  QFETCH(double, largest);
  const std::vector<Disc> discs = strewn(1500, side, smallest, largest);
  std::vector<bool> isNamed(discs.size(), false);
  int last = -1;
  for (const Overlap& overlap : core::overlapsAmong(discs)) {
    QVERIFY(overlap.disc > last);
    last = overlap.disc;
    isNamed[overlap.disc] = true;
    QVERIFY(reallyOverlap(discs[overlap.disc], discs[overlap.other]));
  }
  int overlapping = 0;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!reallyOverlap(discs[i], discs[j])) continue;
      ++overlapping;
      QVERIFY(isNamed[i] || isNamed[j]);
    }
  }
  QVERIFY2(overlapping > 20, "the discs must overlap for this test to mean anything");
}

void OverlapsTest::namesTheLaterOfTwoAlike() {
  const std::vector<Disc> discs{{{1, 1}, 0.02}, {{3, 1}, 0.02}, {{1.03, 1}, 0.03}};
  const std::vector<Overlap> overlaps = core::overlapsAmong(discs);
  QCOMPARE(overlaps.size(), std::size_t{1});
  QCOMPARE(overlaps[0].disc, 2);
  QCOMPARE(overlaps[0].other, 0);
}

void OverlapsTest::namesTheSmallerOfTwo() {
  const std::vector<Disc> discs{{{1, 1}, 0.001}, {{1, 1.2}, 0.5}};
  const std::vector<Overlap> overlaps = core::overlapsAmong(discs);
  QCOMPARE(overlaps.size(), std::size_t{1});
  QCOMPARE(overlaps[0].disc, 0);
  QCOMPARE(overlaps[0].other, 1);
}

void OverlapsTest::touchingIsNoOverlap_data() {
  QTest::addColumn<double>("distance");
  QTest::addColumn<bool>("overlaps");
  QTest::newRow("apart") << 0.31 << false;
  QTest::newRow("touching") << 0.3 << false;
  QTest::newRow("touching but for rounding") << 0.3 * (1 - 0.9e-9) << false;
  QTest::newRow("overlapping by more") << 0.3 * (1 - 1.1e-9) << true;
  QTest::newRow("same center") << 0.0 << true;
}

void OverlapsTest::touchingIsNoOverlap() {
  QFETCH(double, distance);
  QFETCH(bool, overlaps);
  const std::vector<Disc> discs{{{0, 0}, 0.1}, {{0.6 * distance, -0.8 * distance}, 0.2}};
  QCOMPARE(!core::overlapsAmong(discs).empty(), overlaps);
}

void OverlapsTest::leavesOutWhatIsNoDisc() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Disc> discs{{{1, 1}, 0.1},     {{1, 1}, nan},    {{1, 1}, infinity},
                                {{1, 1}, -1},      {{nan, 1}, 0.1},  {{1, nan}, 0.1},
                                {{1, 1e300}, 0.1}, {{1, 1e300}, 0.1}};
  QVERIFY(core::overlapsAmong(discs).empty());
}

void OverlapsTest::namesAllButOneOfAHeap() {
  const std::vector<Disc> discs(500, Disc{{2, 2}, 0.02});
  QCOMPARE(core::overlapsAmong(discs).size(), discs.size() - 1);
}

void OverlapsTest::copesWithAHundredThousand_data() {
  QTest::addColumn<double>("xStep");
  QTest::addColumn<double>("yStep");
  QTest::addColumn<std::size_t>("overlaps");
  QTest::newRow("in one column") << 0.0 << 0.05 << std::size_t{0};
  QTest::newRow("in one row") << 0.05 << 0.0 << std::size_t{0};
  QTest::newRow("in one place") << 0.0 << 0.0 << std::size_t{99999};
}

// Looking at all pairs would take minutes here; the test's time limit is the judge.
void OverlapsTest::copesWithAHundredThousand() {
  QFETCH(double, xStep);
  QFETCH(double, yStep);
  QFETCH(std::size_t, overlaps);
  std::vector<Disc> discs;
  for (int i = 0; i < 100000; ++i) discs.push_back({{1 + xStep * i, 1 + yStep * i}, 0.02});
  QCOMPARE(core::overlapsAmong(discs).size(), overlaps);
}

QTEST_APPLESS_MAIN(OverlapsTest)
#include "overlaps_test.moc"
