#include "core/aim/cut_sweep.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <QtTest>

#include "tests/support/landings.h"

using core::CutSweep;
using core::FirstHit;
using core::Hit;
using core::Landing;
using core::LandingOutcome;
using core::Target;

namespace {

constexpr double kGravity = 9.81, kLength = 1, kRadius = 0.02;
const double kStartAngle = std::numbers::pi / 3;
const Eigen::Vector2d kPivot(3, 2.5);

/// A pendulum let go at 60° without air, in a room so wide that it flies past nothing.
core::Scene pendulum() {
  core::Scene scene;
  scene.airDensity = 0;
  scene.room = {.width = 6, .height = 4};
  scene.weights.resize(1);
  scene.weights[0].radius = kRadius;
  scene.weights[0].rope = core::Rope{.pivot = kPivot, .length = kLength, .angle = kStartAngle};
  return scene;
}

/// When the pendulum passes an angle for the first time, on its way down and up to the other
/// side: with k = sin(θ₀/2) and sin φ = sin(θ/2) / k, t = √(L/g) (K(k) − F(φ, k)).
double timeAt(double angle) {
  const double k = std::sin(kStartAngle / 2);
  const double phi = std::asin(std::sin(angle / 2) / k);
  return std::sqrt(kLength / kGravity) * (std::comp_ellint_1(k) - std::ellint_1(k, phi));
}

/// Where it lands if it is cut at that angle on this way: ω² = 2 g/L (cos θ − cos θ₀).
double landingPlace(double angle) {
  const double omega =
      -std::sqrt(2 * kGravity / kLength * (std::cos(angle) - std::cos(kStartAngle)));
  const double x = kPivot.x() + kLength * std::sin(angle);
  const double y = kPivot.y() - kLength * std::cos(angle) - kRadius;
  const double vx = kLength * omega * std::cos(angle), vy = kLength * omega * std::sin(angle);
  return x + vx * (vy + std::sqrt(vy * vy + 2 * kGravity * y)) / kGravity;
}

double swingTime() {
  return 4 * std::sqrt(kLength / kGravity) * std::comp_ellint_1(std::sin(kStartAngle / 2));
}

/// Its solution by bisection: f falls through zero once between low and high, or rises.
template <class Function>
double rootOf(const Function& f, double low, double high) {
  const bool rises = f(low) < 0;
  for (int i = 0; i < 200; ++i) {
    const double middle = std::midpoint(low, high);
    ((f(middle) < 0) == rises ? low : high) = middle;
  }
  return low;
}

CutSweep computed(const core::Scene& scene, const core::Solver& solver, double until) {
  CutSweep sweep(scene, solver, {.weight = 0, .from = 0, .until = until, .longestWait = 5});
  if (!sweep.compute()) qFatal("nobody stopped it");
  return sweep;
}

/// So exact on these scenes that what is left is the sweep's own error.
const core::Solver kExact{.method = "rk4", .step = 1.0 / 400};

}  // namespace

class CutSweepTest : public QObject {
  Q_OBJECT

 private slots:
  void everyLandingLiesOnTheExactCurve();
  void findsTheMomentsThatHit_data();
  void findsTheMomentsThatHit();
  void findsEveryMomentThatHitsTheCenter();
  void theMethodDecidesWhenToCut();
  void findsTheFurthestThrow();
  void enclosesAJump();
  void hitsEndAtAJump();
  void marksWhatHitTheWallFirst();
  void seesATargetThatTheCurveOnlyTouches();
  void saysThatNothingHits();
  void endsWithAHangingRunThatCannotGoOn();
  void isTheSameTwice();
  void endsWhenItIsTold();
};

void CutSweepTest::everyLandingLiesOnTheExactCurve() {
  const CutSweep sweep = computed(pendulum(), kExact, swingTime() / 2);
  QVERIFY(sweep.isResolved());
  QVERIFY(sweep.landings().size() > 100);
  double before = -1;
  for (const Landing& landing : sweep.landings()) {
    QVERIFY(landing.cutTime > before);
    before = landing.cutTime;
    QCOMPARE(landing.outcome, LandingOutcome::kLanded);
    QCOMPARE(landing.firstHit, FirstHit::kNothing);
    if (landing.cutTime < 1e-3 || landing.cutTime > swingTime() / 2 - 1e-3) continue;
    const double angle =
        rootOf([&](double at) { return timeAt(at) - landing.cutTime; }, -kStartAngle, kStartAngle);
    // Near its turning points the angle is known to the root of the rounding error only.
    QVERIFY(std::abs(landing.place - landingPlace(angle)) < 1e-6);
  }
}

void CutSweepTest::findsTheMomentsThatHit_data() {
  QTest::addColumn<double>("degrees");
  // The throw to the left goes furthest for a cut at about −36°; these are on both sides.
  for (const double degrees : {40.0, 10.0, -20.0, -30.0, -45.0})
    QTest::addRow("%g degrees", degrees) << degrees;
}

void CutSweepTest::findsTheMomentsThatHit() {
  QFETCH(double, degrees);
  const double angle = degrees * std::numbers::pi / 180;
  const double half = 0.005;
  CutSweep sweep = computed(pendulum(), kExact, swingTime() / 2);
  const Target target{landingPlace(angle), 2 * half};
  const auto hits = sweep.hitsOn(target);
  const auto found = std::ranges::find_if(
      *hits, [&](const Hit& hit) { return hit.from < timeAt(angle) && timeAt(angle) < hit.until; });
  QVERIFY(found != hits->end());
  // The method's error at this step is under 10⁻⁹ s; a degree further the moment is 5 ms off.
  const auto exactEdge = [&](double place, double beyond) {
    return timeAt(rootOf([&](double at) { return landingPlace(at) - place; }, angle, beyond));
  };
  const double step = 0.05;  // [rad], beyond both edges and before the curve turns
  const bool fallsWithTime = landingPlace(angle + step) > landingPlace(angle - step);
  const double first = fallsWithTime ? target.east() : target.west();
  const double last = fallsWithTime ? target.west() : target.east();
  QVERIFY(std::abs(found->best - timeAt(angle)) < 1e-8);
  QVERIFY(found->offCenter < 1e-9);
  QVERIFY(std::abs(found->from - exactEdge(first, angle + step)) < 1e-8);
  QVERIFY(std::abs(found->until - exactEdge(last, angle - step)) < 1e-8);
}

void CutSweepTest::findsEveryMomentThatHitsTheCenter() {
  // In vacuum every swing is like the first, and one way of it like the other in a mirror.
  CutSweep sweep = computed(pendulum(), kExact, 3 * swingTime());
  const double angle = -0.2;
  const auto hits = sweep.hitsOn({landingPlace(angle), 0.02});
  std::vector<double> centers;
  for (const Hit& hit : *hits)
    centers.insert(centers.end(), hit.centers.begin(), hit.centers.end());
  for (int swing = 0; swing < 3; ++swing) {
    const double exact = timeAt(angle) + swing * swingTime();
    QVERIFY(
        std::ranges::any_of(centers, [&](double time) { return std::abs(time - exact) < 1e-7; }));
  }
  // Each of them really hits: cut then, a run from the start lands there.
  for (const double time : centers) {
    const core::LandingFinder finder = tests::finderFor(pendulum(), kExact, 0, time, 5);
    QVERIFY(std::abs(tests::landingIn(finder, time).place - landingPlace(angle)) < 1e-9);
  }
}

void CutSweepTest::theMethodDecidesWhenToCut() {
  const double angle = -0.2;
  const auto bestOf = [&](const core::Solver& solver) {
    CutSweep sweep = computed(pendulum(), solver, swingTime() / 2);
    return sweep.hitsOn({landingPlace(angle), 0.02})->front().best;
  };
  const double rungeKutta = bestOf({.method = "rk4", .step = 1.0 / 60});
  const double euler = bestOf({.method = "euler", .step = 1.0 / 60});
  QVERIFY(std::abs(rungeKutta - timeAt(angle)) < 1e-6);
  // Of order 1: a sixtieth of a second's step is some milliseconds off.
  QVERIFY(std::abs(euler - timeAt(angle)) > 1e-3);
  QVERIFY(std::abs(euler - timeAt(angle)) < 5e-2);
}

void CutSweepTest::findsTheFurthestThrow() {
  const CutSweep sweep = computed(pendulum(), kExact, swingTime() / 2);
  const auto landings = sweep.landings();
  const auto furthest = std::ranges::min_element(landings, {}, &Landing::place);
  double low = -kStartAngle, high = 0;
  for (int i = 0; i < 200; ++i) {
    const double third = (high - low) / 3;
    (landingPlace(low + third) > landingPlace(high - third) ? low : high) +=
        landingPlace(low + third) > landingPlace(high - third) ? third : -third;
  }
  // A turn is known to the root of the rounding error in time, and to rounding in place.
  QVERIFY(std::abs(furthest->place - landingPlace(low)) < 1e-10);
  QVERIFY(std::abs(furthest->cutTime - timeAt(low)) < 1e-4);
}

namespace {

/// A ball thrown from the left meets the weight, which hangs still, at a moment known from both
/// paths.
core::Scene withABall() {
  core::Scene scene = pendulum();
  scene.weights[0].rope->angle = 0;
  core::Weight ball;
  ball.radius = kRadius;
  ball.position = {1, 2.23};
  ball.velocity = {4, 1};
  scene.weights.push_back(ball);
  return scene;
}

double meetingTime() {
  const auto apart = [](double time) {
    const Eigen::Vector2d ball(1 + 4 * time, 2.23 + time - kGravity / 2 * time * time);
    return (ball - (kPivot - Eigen::Vector2d(0, kLength))).norm() - 2 * kRadius;
  };
  return rootOf(apart, 0, 0.5);
}

}  // namespace

void CutSweepTest::enclosesAJump() {
  const CutSweep sweep = computed(withABall(), kExact, 1);
  const auto landings = sweep.landings();
  int around = 0;
  for (std::size_t i = 1; i < landings.size(); ++i) {
    const Landing &a = landings[i - 1], &b = landings[i];
    if (areAlike(a, b) || a.cutTime > meetingTime() || b.cutTime < meetingTime()) continue;
    ++around;
    QVERIFY(b.cutTime - a.cutTime <= CutSweep::kSharpness);
    QVERIFY(std::abs(b.place - a.place) > 0.01);
  }
  QCOMPARE(around, 1);
  QVERIFY(sweep.isResolved());
}

void CutSweepTest::hitsEndAtAJump() {
  CutSweep sweep = computed(withABall(), kExact, 1);
  const auto landings = sweep.landings();
  const auto after = std::ranges::find_if(
      landings, [](const Landing& landing) { return landing.cutTime > meetingTime() + 1e-9; });
  const auto hits = sweep.hitsOn({after->place, 0.01});
  const auto hit = std::ranges::find_if(
      *hits, [](const Hit& candidate) { return std::abs(candidate.from - meetingTime()) < 1e-3; });
  QVERIFY(hit != hits->end());
  QVERIFY(std::abs(hit->from - meetingTime()) < 2 * CutSweep::kSharpness);
  QCOMPARE(hit->firstHit, FirstHit::kNothing);  // after the cut
}

void CutSweepTest::marksWhatHitTheWallFirst() {
  core::Scene scene = pendulum();
  // The wall stands where the furthest throw would go.
  scene.room.width = 6;
  scene.weights[0].rope->pivot.x() = 1.3;
  const double shift = kPivot.x() - 1.3;
  CutSweep sweep = computed(scene, kExact, swingTime() / 2);
  const double angle = -0.3;
  const double mirrored = 2 * kRadius - (landingPlace(angle) - shift);
  QVERIFY(landingPlace(angle) - shift < kRadius);
  scene.room.restitution = 1;
  sweep = computed(scene, kExact, swingTime() / 2);
  const auto hits = sweep.hitsOn({mirrored, 0.01});
  // Without friction and loss the wall is a mirror.
  const auto hit = std::ranges::find_if(
      *hits, [&](const Hit& candidate) { return std::abs(candidate.best - timeAt(angle)) < 1e-8; });
  QVERIFY(hit != hits->end());
  QCOMPARE(hit->firstHit, FirstHit::kWall);
}

void CutSweepTest::seesATargetThatTheCurveOnlyTouches() {
  CutSweep sweep = computed(pendulum(), kExact, swingTime() / 2);
  const auto landings = sweep.landings();
  const double furthest = std::ranges::min_element(landings, {}, &Landing::place)->place;
  // Its near edge is a tenth of a millimetre within reach, its center out of it.
  const Target target{furthest - 0.05 + 1e-4, 0.1};
  const auto hits = sweep.hitsOn(target);
  QCOMPARE(hits->size(), std::size_t{1});
  QVERIFY(hits->front().centers.empty());
  QVERIFY(std::abs(hits->front().offCenter - (0.05 - 1e-4)) < 1e-9);
  QVERIFY(hits->front().from < hits->front().best && hits->front().best < hits->front().until);
  QVERIFY(sweep.hitsOn({target.center - 2e-4, 0.1})->empty());
}

void CutSweepTest::saysThatNothingHits() {
  CutSweep sweep = computed(pendulum(), kExact, 1);
  QVERIFY(sweep.hitsOn({0.1, 0.1})->empty());
  core::Scene weightless = pendulum();
  weightless.gravity = 0;
  CutSweep never = computed(weightless, kExact, 1);
  QCOMPARE(never.landings().front().outcome, LandingOutcome::kNotInTime);
  QVERIFY(never.hitsOn({3, 6})->empty());
}

void CutSweepTest::endsWithAHangingRunThatCannotGoOn() {
  const core::Scene scene = tests::beyondNumbers(pendulum());
  const CutSweep sweep = computed(scene, {.method = "euler", .step = 0.1}, 5);
  QVERIFY(!sweep.landings().empty());
  QVERIFY(sweep.landings().back().cutTime < 1);
}

void CutSweepTest::isTheSameTwice() {
  const auto one = computed(withABall(), kExact, 1).landings();
  CutSweep again = computed(withABall(), kExact, 1);
  const auto other = again.landings();
  QCOMPARE(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    QVERIFY(one[i].cutTime == other[i].cutTime && one[i].place == other[i].place);
  }
  // Nor does it matter what was asked before.
  const auto hits = again.hitsOn({3.05, 0.2});
  QVERIFY(again.hitsOn({2.5, 0.2}));
  const auto repeated = again.hitsOn({3.05, 0.2});
  QCOMPARE(repeated->size(), hits->size());
  for (std::size_t i = 0; i < hits->size(); ++i) QCOMPARE((*repeated)[i].best, (*hits)[i].best);
}

void CutSweepTest::endsWhenItIsTold() {
  CutSweep sweep(pendulum(), kExact, {.until = 5});
  QVERIFY(!sweep.compute([](double) { return false; }));
  CutSweep later(pendulum(), kExact, {.until = 5});
  double latest = 0;
  QVERIFY(!later.compute([&](double share) {
    latest = share;
    return share < 0.5;
  }));
  QVERIFY(0.5 <= latest && latest < 0.6);
}

QTEST_APPLESS_MAIN(CutSweepTest)
#include "cut_sweep_test.moc"
