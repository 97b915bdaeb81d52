#include "core/contact/impulse.h"

#include <cmath>
#include <random>

#include <QtTest>

using core::CollidingWeight;
using core::wallImpact;
using core::WallImpact;
using Eigen::Vector2d;

namespace {

/// Two weights about to collide along a direction, made up by a seed.
struct Collision {
  CollidingWeight a, b;
  Vector2d normal;
  double restitution;

  explicit Collision(int seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-3, 3), share(0, 1), decade(-6, 9);
    const auto velocity = [&] { return Vector2d(number(random), number(random)); };
    a = {velocity(), std::pow(10, decade(random))};
    b = {velocity(), std::pow(10, decade(random))};
    normal = velocity().normalized();
    restitution = share(random);
    if ((a.velocity - b.velocity).dot(normal) < 0) normal = -normal;
  }

  double impulse() const { return core::collisionImpulse(a, b, normal, restitution); }
  double loss() const { return core::collisionLoss(a, b, normal, restitution); }
  Vector2d changeOfA() const { return a.velocityChange(-impulse(), normal); }
  Vector2d changeOfB() const { return b.velocityChange(impulse(), normal); }
};

/// ½ m (|v + change|² − |v|²), without the digits a difference of squares would lose.
double energyGain(const CollidingWeight& weight, const Vector2d& change) {
  return weight.mass * change.dot(weight.velocity + 0.5 * change);
}

}  // namespace

class ImpulseTest : public QObject {
  Q_OBJECT

 private slots:
  void swapsVelocitiesOfEqualElasticWeights();
  void agreesWithAnObliqueCollisionWorkedByHand();
  void keepsMomentum();
  void restoresTheShareOfTheApproachSpeed();
  void losesWhatItSays();
  void leavesPartingWeightsAlone();
  void keepsAWeightOnItsTrack();
  void countsATrackByItsAngle();
  void cannotPushTwoWeightsAcrossTheirTracks();
  void reflectsFromAWall();
  void brakesAlongAWallByFriction();
  void neverTurnsASlipAround();
  void losesAtAWallWhatItSays();
  void leavesAWeightThatMovesAwayAlone();
};

void ImpulseTest::swapsVelocitiesOfEqualElasticWeights() {
  const CollidingWeight a{{2, 0.5}, 3}, b{{-1, 0.25}, 3};
  const Vector2d n(1, 0);
  const double impulse = core::collisionImpulse(a, b, n, 1);
  QCOMPARE(impulse, 9.0);
  QCOMPARE(a.velocity + a.velocityChange(-impulse, n), Vector2d(-1, 0.5));
  QCOMPARE(b.velocity + b.velocityChange(impulse, n), Vector2d(2, 0.25));
  QCOMPARE(core::collisionLoss(a, b, n, 1), 0.0);
}

void ImpulseTest::agreesWithAnObliqueCollisionWorkedByHand() {
  // Along n = (0.6, 0.8): a comes with 5, b stands. 1/M = 1/1 + 1/4; J = 1.5 · 5 / 1.25 = 6.
  const CollidingWeight a{{3, 4}, 1}, b{{0, 0}, 4};
  const Vector2d n(0.6, 0.8);
  QVERIFY(std::abs(core::collisionImpulse(a, b, n, 0.5) - 6) < 1e-14);
  QVERIFY((b.velocityChange(6, n) - Vector2d(0.9, 1.2)).norm() < 1e-15);
  // ½ (1 − ¼) 25 / 1.25
  QVERIFY(std::abs(core::collisionLoss(a, b, n, 0.5) - 7.5) < 1e-14);
}

void ImpulseTest::keepsMomentum() {
  for (int seed = 0; seed < 200; ++seed) {
    const Collision c(seed);
    const Vector2d given = c.a.mass * c.changeOfA(), taken = c.b.mass * c.changeOfB();
    QVERIFY(c.impulse() > 0);
    QVERIFY((given + taken).norm() <= 1e-15 * c.impulse());
  }
}

void ImpulseTest::restoresTheShareOfTheApproachSpeed() {
  for (int seed = 0; seed < 200; ++seed) {
    const Collision c(seed);
    const double approach = (c.a.velocity - c.b.velocity).dot(c.normal);
    const double change = (c.changeOfA() - c.changeOfB()).dot(c.normal);
    QVERIFY(std::abs(approach + change + c.restitution * approach) < 1e-14 * approach);
  }
}

void ImpulseTest::losesWhatItSays() {
  for (int seed = 0; seed < 200; ++seed) {
    const Collision c(seed);
    const double gainA = energyGain(c.a, c.changeOfA()), gainB = energyGain(c.b, c.changeOfB());
    QVERIFY(c.loss() >= 0);
    const double rounding = 1e-15 * c.impulse() * (c.a.velocity.norm() + c.b.velocity.norm());
    QVERIFY(std::abs(gainA + gainB + c.loss()) < rounding);
  }
}

void ImpulseTest::leavesPartingWeightsAlone() {
  const CollidingWeight a{{-1, 0}, 1}, b{{1, 0}, 2};
  QCOMPARE(core::collisionImpulse(a, b, {1, 0}, 0.7), 0.0);
  QCOMPARE(core::collisionLoss(a, b, {1, 0}, 0.7), 0.0);
  QCOMPARE(core::collisionImpulse(a, a, {1, 0}, 0.7), 0.0);
}

void ImpulseTest::keepsAWeightOnItsTrack() {
  const Vector2d track(0.6, 0.8);
  const CollidingWeight tied{2 * track, 0.5, track};
  const Vector2d change = tied.velocityChange(3, {1, 0});
  QVERIFY(std::abs(change.x() * track.y() - change.y() * track.x()) < 1e-15);
  // J (t·n) / m = 3 · 0.6 / 0.5
  QVERIFY(std::abs(change.dot(track) - 3.6) < 1e-14);
}

void ImpulseTest::countsATrackByItsAngle() {
  const Vector2d track(0.6, 0.8);
  const CollidingWeight tied{{0, 0}, 0.5, track};
  QVERIFY(std::abs(tied.inverseMass(track) - 2) < 1e-15);
  QVERIFY(std::abs(tied.inverseMass({1, 0}) - 0.72) < 1e-15);
  const CollidingWeight free{{4, 0}, 1};
  // J = (1 + 0.5) · 4 / (1 + 0.72); both parts of the energy are told apart by it.
  const double impulse = core::collisionImpulse(free, tied, {1, 0}, 0.5);
  QVERIFY(std::abs(impulse - 6 / 1.72) < 1e-14);
  const double gain = energyGain(free, free.velocityChange(-impulse, {1, 0})) +
                      energyGain(tied, tied.velocityChange(impulse, {1, 0}));
  QVERIFY(std::abs(gain + core::collisionLoss(free, tied, {1, 0}, 0.5)) < 1e-14);
}

void ImpulseTest::cannotPushTwoWeightsAcrossTheirTracks() {
  const CollidingWeight a{{0, 1}, 1, {0, 1}}, b{{0, -1}, 1, {0, 1}};
  QCOMPARE(core::collisionImpulse(a, b, {1, 0}, 1), 0.0);
  QCOMPARE(core::collisionLoss(a, b, {1, 0}, 0), 0.0);
}

void ImpulseTest::reflectsFromAWall() {
  const WallImpact impact = wallImpact({-3, 2}, 0.19, /*inward*/ {1, 0}, 0.5, 0);
  QCOMPARE(impact.velocity, Vector2d(1.5, 2));
  // ½ m (9 − 2.25)
  QVERIFY(std::abs(impact.energyLost - 0.5 * 0.19 * 6.75) < 1e-15);
}

void ImpulseTest::brakesAlongAWallByFriction() {
  // min(0.1 · 1.5 · 4, 2) = 0.6 of the slip goes, whichever way it slips.
  QVERIFY((wallImpact({2, -4}, 1, {0, 1}, 0.5, 0.1).velocity - Vector2d(1.4, 2)).norm() < 1e-15);
  QVERIFY((wallImpact({-2, -4}, 1, {0, 1}, 0.5, 0.1).velocity - Vector2d(-1.4, 2)).norm() < 1e-15);
}

void ImpulseTest::neverTurnsASlipAround() {
  const WallImpact impact = wallImpact({2, 4}, 2, /*ceiling*/ {0, -1}, 0.5, 10);
  QCOMPARE(impact.velocity, Vector2d(0, -2));
  QVERIFY(std::abs(impact.energyLost - 16) < 1e-14);
}

void ImpulseTest::losesAtAWallWhatItSays() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> speed(-5, 5), share(0, 1);
  for (int i = 0; i < 200; ++i) {
    const Vector2d before(speed(random), speed(random));
    const double e = share(random), friction = share(random);
    const WallImpact impact = wallImpact(before, 3, {0, 1}, e, friction);
    const double lost = 1.5 * (before.squaredNorm() - impact.velocity.squaredNorm());
    QVERIFY(impact.energyLost >= 0);
    QVERIFY(std::abs(impact.energyLost - lost) < 1e-13);
  }
}

void ImpulseTest::leavesAWeightThatMovesAwayAlone() {
  const WallImpact impact = wallImpact({1, 2}, 1, {0, 1}, 0.5, 1);
  QCOMPARE(impact.velocity, Vector2d(1, 2));
  QCOMPARE(impact.energyLost, 0.0);
}

QTEST_APPLESS_MAIN(ImpulseTest)
#include "impulse_test.moc"
