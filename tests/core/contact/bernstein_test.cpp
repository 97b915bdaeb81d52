#include "core/contact/bernstein.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <QtTest>

using core::Bernstein;
using core::firstFall;

namespace {

/// sign · ∏ (u − root) in Bernstein form, one factor after the other: a factor has the
/// coefficients −root and 1 − root.
template <int kDegree>
Bernstein<kDegree> fromRoots(const std::array<double, kDegree>& roots, double sign = 1) {
  std::vector<double> product{sign};
  for (const double root : roots) {
    const auto degree = static_cast<int>(product.size()) - 1;
    std::vector<double> next(product.size() + 1, 0);
    for (int i = 0; i <= degree + 1; ++i) {
      if (i <= degree) next[i] += product[i] * -root * (degree + 1 - i) / (degree + 1);
      if (i > 0) next[i] += product[i - 1] * (1 - root) * i / (degree + 1);
    }
    product = next;
  }
  Bernstein<kDegree> result;
  std::ranges::copy(product, result.begin());
  return result;
}

double valueOf(const std::array<double, 6>& roots, double u) {
  double value = 1;
  for (const double root : roots) value *= u - root;
  return value;
}

constexpr std::array<double, 6> kRoots{0.3, 0.5, 0.9, -1, 2, 4};

}  // namespace

using Roots = std::array<double, 3>;
Q_DECLARE_METATYPE(Roots)

class BernsteinTest : public QObject {
  Q_OBJECT

 private slots:
  void evaluatesValueAndSlope();
  void halvesWithoutChangingTheCurve();
  void dividesOutARootAtZero();
  void signChangesBoundTheRoots();
  void findsTheFirstFall_data();
  void findsTheFirstFall();
  void seesNoFallOutside();
  void findsTheFirstFallOfAnyPolynomial();
  void passesADoubleRootOnItsWayToTheFall();
  void findsADipBetweenTwoCloseRoots();
  void overlooksADipWithinTheTolerance();
  void seesNoFallWhereItOnlyGrazes();
};

void BernsteinTest::evaluatesValueAndSlope() {
  const Bernstein<6> b = fromRoots<6>(kRoots);
  for (double u = 0; u <= 1; u += 0.0625) {
    const auto [value, slope] = core::valueAndSlope<6>(b, u);
    QVERIFY(std::abs(value - valueOf(kRoots, u)) < 1e-14);
    const double difference = (valueOf(kRoots, u + 1e-5) - valueOf(kRoots, u - 1e-5)) / 2e-5;
    // Third derivative · 10⁻¹⁰/6, and rounding / 10⁻⁵.
    QVERIFY(std::abs(slope - difference) < 1e-8);
  }
}

void BernsteinTest::halvesWithoutChangingTheCurve() {
  const Bernstein<6> b = fromRoots<6>(kRoots);
  const auto [left, right] = core::halves<6>(b);
  for (double u = 0; u <= 1; u += 0.125) {
    QVERIFY(std::abs(core::valueAndSlope<6>(left, u).first - valueOf(kRoots, u / 2)) < 1e-14);
    QVERIFY(std::abs(core::valueAndSlope<6>(right, u).first - valueOf(kRoots, 0.5 + u / 2)) <
            1e-14);
  }
}

void BernsteinTest::dividesOutARootAtZero() {
  const Bernstein<6> b = fromRoots<6>({0, 0.5, 0.9, -1, 2, 4});
  const Bernstein<5> quotient = core::withoutRootAtZero<6>(b);
  const Bernstein<5> expected = fromRoots<5>({0.5, 0.9, -1, 2, 4});
  for (int i = 0; i <= 5; ++i) QVERIFY(std::abs(quotient[i] - expected[i]) < 1e-14);
}

void BernsteinTest::signChangesBoundTheRoots() {
  QCOMPARE(core::signChanges<6>(fromRoots<6>(kRoots)), 3);
  QCOMPARE(core::signChanges<3>(fromRoots<3>({-1, 2, 3})), 0);
  QCOMPARE((core::signChanges<3>({1, 0, 0, -1})), 1);
  QCOMPARE((core::signChanges<3>({1, 0, 0, 1})), 0);
  QCOMPARE((core::signChanges<3>({0, 0, 0, 0})), 0);
}

void BernsteinTest::findsTheFirstFall_data() {
  QTest::addColumn<Roots>("roots");
  QTest::addColumn<double>("sign");
  QTest::addColumn<double>("fall");
  QTest::addColumn<double>("accuracy");
  QTest::newRow("one root") << Roots{0.4, 2, 3} << -1. << 0.4 << 1e-15;
  QTest::newRow("the first of two falls") << Roots{0.2, 0.5, 0.9} << -1. << 0.2 << 1e-15;
  QTest::newRow("starts below") << Roots{0.2, 0.5, 0.9} << 1. << 0. << 0.;
  QTest::newRow("at the end") << Roots{1, -2, 3} << 1. << 1. << 0.;
  QTest::newRow("just before the end") << Roots{1 - 1e-12, -2, 3} << 1. << 1 - 1e-12 << 1e-15;
  QTest::newRow("just after the start") << Roots{1e-12, -2, 3} << 1. << 1e-12 << 1e-15;
  // A threefold root moves by the third root of the rounding.
  QTest::newRow("threefold") << Roots{0.3, 0.3, 0.3} << -1. << 0.3 << 1e-5;
}

void BernsteinTest::findsTheFirstFall() {
  QFETCH(Roots, roots);
  QFETCH(double, sign);
  QFETCH(double, fall);
  QFETCH(double, accuracy);
  const std::optional<double> found = firstFall<3>(fromRoots<3>(roots, sign), 0);
  QVERIFY(found);
  QVERIFY2(std::abs(*found - fall) <= accuracy, qPrintable(QString::number(*found, 'g', 17)));
}

void BernsteinTest::seesNoFallOutside() {
  QVERIFY(!firstFall<3>(fromRoots<3>({-0.2, 1.5, 1.9}), 0));
  QVERIFY(!firstFall<3>(fromRoots<3>({1 + 1e-12, 2, 3}, -1), 0));
  QVERIFY(!(firstFall<3>({1, 2, 2, 1}, 0)));
}

void BernsteinTest::findsTheFirstFallOfAnyPolynomial() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-1, 2);
  for (int round = 0; round < 2000; ++round) {
    std::array<double, 6> roots;
    for (double& root : roots) root = place(random);
    std::ranges::sort(roots);
    const bool crowded = std::ranges::adjacent_find(
                             roots, [](double a, double b) { return b - a < 0.01; }) != roots.end();
    if (crowded) continue;
    const double sign = valueOf(roots, 0) > 0 ? 1 : -1;
    const auto first = std::ranges::find_if(roots, [](double root) { return root >= 0; });
    const std::optional<double> found = firstFall<6>(fromRoots<6>(roots, sign), 0);
    QCOMPARE(found.has_value(), first != roots.end() && *first <= 1);
    // Rounding of 10⁻¹⁵ over a slope of at least 10⁻⁷ where six roots stand close.
    if (found) QVERIFY(std::abs(*found - *first) < 1e-8);
  }
}

void BernsteinTest::passesADoubleRootOnItsWayToTheFall() {
  const std::optional<double> found = firstFall<3>(fromRoots<3>({0.3, 0.3, 0.7}, -1), 1e-14);
  QVERIFY(found);
  QVERIFY(std::abs(*found - 0.7) < 1e-12);
}

void BernsteinTest::findsADipBetweenTwoCloseRoots() {
  // The dip is 2.5·10⁻¹³ deep.
  const std::optional<double> found = firstFall<2>(fromRoots<2>({0.31, 0.31 + 1e-6}), 0);
  QVERIFY(found);
  QVERIFY(std::abs(*found - 0.31) < 1e-9);
}

void BernsteinTest::overlooksADipWithinTheTolerance() {
  QVERIFY(!firstFall<2>(fromRoots<2>({0.31, 0.31 + 1e-6}), 1e-12));
}

void BernsteinTest::seesNoFallWhereItOnlyGrazes() {
  for (const double root : {0.1, 0.3, 0.5, 0.77}) {
    QVERIFY(!firstFall<2>(fromRoots<2>({root, root}), 1e-15));
    QVERIFY(!firstFall<4>(fromRoots<4>({root, root, root, root}), 1e-15));
  }
}

QTEST_APPLESS_MAIN(BernsteinTest)
#include "bernstein_test.moc"
