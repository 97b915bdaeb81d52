#include "core/contact/first_contact.h"

#include <cmath>
#include <random>

#include <QtTest>

using core::Bernstein;
using core::Contact;
using core::ContactTolerance;
using core::Path;
using Eigen::Vector2d;

namespace {

constexpr ContactTolerance kTolerance;

/// Exact path of a throw.
Path thrown(const Vector2d& from, const Vector2d& velocity, const Vector2d& acceleration,
            double duration) {
  return Path::through(from, velocity,
                       from + duration * velocity + 0.5 * duration * duration * acceleration,
                       velocity + duration * acceleration, duration);
}

Path straight(const Vector2d& from, const Vector2d& velocity, double duration) {
  return thrown(from, velocity, {0, 0}, duration);
}

/// Distance to a wall at zero as a polynomial.
Bernstein<3> fall(double from, double speed, double acceleration, double duration) {
  return thrown({from, 0}, {speed, 0}, {acceleration, 0}, duration).coordinate(0);
}

/// Second derivative of the distance from the origin for a weight on the circle around it.
double outwardAcceleration(const Vector2d& place, const Vector2d& velocity, double gravity) {
  const double length = place.norm();
  const double across = (place.x() * velocity.y() - place.y() * velocity.x()) / length;
  return across * across / length - gravity * place.y() / length;
}

}  // namespace

class FirstContactTest : public QObject {
  Q_OBJECT

 private slots:
  void neverTunnels_data();
  void neverTunnels();
  void agreesWithTheClosedFormForAnyStraightPaths();
  void tellsANearMissFromAGraze();
  void findsTheFirstOfTwoMeetings();
  void lettingGoIsNotTouching();
  void touchingWeightsThatPartMayMeetAgain();
  void touchingWeightsThatApproachHitAtOnce();
  void touchingWeightsAtRestPress();
  void touchingWeightsAtRestStayOrPart();
  void anOffsetWithinRoundingDoesNotPress();
  void overlappingWeightsMayPart();
  void fallsOnAWallAtTheRightMoment();
  void leavesAWallAndReturns();
  void pressesAgainstAWall();
  void liesStillAtAWallWithoutAPull();
  void goesTautAtTheRightMoment();
  void isTautAtOnceWhenItMovesOutOfItsCircle();
  void goesTautAgainAfterMovingIn();
  void goesTautAgainAfterGoingSlack_data();
  void goesTautAgainAfterGoingSlack();
  void staysSlackWhileItFlies();
};

void FirstContactTest::neverTunnels_data() {
  QTest::addColumn<double>("gap");
  QTest::addColumn<double>("speed");
  QTest::addColumn<double>("duration");
  for (const double gap : {1e-9, 0.01, 100.0})
    for (const double speed : {1.0, 1e5})
      for (const double duration : {1e-7, 1e-3, 1.0, 10.0})
        QTest::addRow("%g m at %g m/s in %g s", gap, speed, duration) << gap << speed << duration;
}

void FirstContactTest::neverTunnels() {
  QFETCH(double, gap);
  QFETCH(double, speed);
  QFETCH(double, duration);
  const double touching = 0.04;
  const Path a = straight({0, 1}, {speed, 0}, duration);
  const Path b = straight({gap + touching, 1}, {-speed, 0}, duration);
  const std::optional<Contact> contact = core::firstContact(a, b, touching, duration, kTolerance);
  const double moment = gap / (2 * speed);
  QCOMPARE(contact.has_value(), moment <= duration);
  if (!contact) return;
  QVERIFY(!contact->pressing);
  // The gap is read from places of its own size, and the two run through at 2·speed; over a
  // long way the squared gap keeps 10⁻¹⁵ of the way's square.
  const double way = gap + touching + 2 * speed * duration;
  const double rounding = 1e-15 * way * way / (touching * 2 * speed);
  QVERIFY(std::abs(contact->u * duration - moment) < rounding + 1e-15 * duration);
}

void FirstContactTest::agreesWithTheClosedFormForAnyStraightPaths() {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-1, 1), decade(-2, 2);
  int meetings = 0;
  for (int round = 0; round < 5000; ++round) {
    const double touching = 0.3;
    const Vector2d apart(place(random), place(random));
    const Vector2d velocity = std::pow(10, decade(random)) * Vector2d(place(random), place(random));
    if (apart.norm() < touching + 1e-3) continue;
    const std::optional<Contact> contact = core::firstContact(
        straight(apart, velocity, 1), straight({0, 0}, {0, 0}, 1), touching, 1, kTolerance);
    // |d + v t|² = R²
    const double vv = velocity.squaredNorm(), dv = apart.dot(velocity);
    const double root = dv * dv - vv * (apart.squaredNorm() - touching * touching);
    const double moment = root < 0 || dv > 0 ? 2 : (-dv - std::sqrt(root)) / vv;
    QCOMPARE(contact.has_value(), moment <= 1);
    if (!contact) continue;
    ++meetings;
    QVERIFY(std::abs(contact->u - moment) < 1e-9);
  }
  QVERIFY(meetings > 300);
}

void FirstContactTest::tellsANearMissFromAGraze() {
  const Path still = straight({0, 0}, {0, 0}, 1);
  const auto passing = [&](double height) {
    return core::firstContact(straight({-1, height}, {2, 0}, 1), still, 0.2, 1, kTolerance);
  };
  QVERIFY(!passing(0.2 + 1e-12));
  QVERIFY(passing(0.2 - 1e-12));
  QVERIFY(std::abs(passing(0.2 - 1e-12)->u - 0.5) < 1e-5);
}

void FirstContactTest::findsTheFirstOfTwoMeetings() {
  // Up through a weight that stands there, and down again: 4 m/s against 8 m/s².
  const std::optional<Contact> contact = core::firstContact(
      thrown({0, 0}, {0, 4}, {0, -8}, 1), straight({0, 0.9}, {0, 0}, 1), 0.15, 1, kTolerance);
  QVERIFY(contact);
  // 4 t − 4 t² = 0.75
  QVERIFY(std::abs(contact->u - 0.25) < 1e-14);
}

void FirstContactTest::lettingGoIsNotTouching() {
  const Path a = straight({0, 0}, {0, 0}, 1);
  QVERIFY(!core::firstContact(a, straight({0.2, 0}, {1, 0}, 1), 0.2, 1, kTolerance));
  QVERIFY(!core::firstContact(a, straight({0.2, 0}, {1e5, 0}, 1), 0.2, 1, kTolerance));
  QVERIFY(!core::firstContact(a, straight({0.2, 0}, {1e-9, 3}, 1), 0.2, 1, kTolerance));
  QVERIFY(!core::firstContact(a, straight({0.2 - 1e-13, 0}, {1e-6, 0}, 1), 0.2, 1, kTolerance));
}

void FirstContactTest::touchingWeightsThatPartMayMeetAgain() {
  // Thrown up from the top of the other one: back after 2 v / g.
  const std::optional<Contact> contact = core::firstContact(
      straight({0, 0}, {0, 0}, 1), thrown({0, 0.2}, {0, 2}, {0, -10}, 1), 0.2, 1, kTolerance);
  QVERIFY(contact);
  QVERIFY(!contact->pressing);
  QVERIFY(std::abs(contact->u - 0.4) < 1e-12);
}

void FirstContactTest::touchingWeightsThatApproachHitAtOnce() {
  const std::optional<Contact> contact = core::firstContact(
      straight({0, 0}, {0, 0}, 1), straight({0.2, 0}, {-1e-6, 0}, 1), 0.2, 1, kTolerance);
  QVERIFY(contact);
  QCOMPARE(contact->u, 0.0);
  QVERIFY(!contact->pressing);
}

void FirstContactTest::touchingWeightsAtRestPress() {
  const std::optional<Contact> contact = core::firstContact(
      straight({0, 0}, {0, 0}, 1), thrown({0, 0.2}, {0, 0}, {0, -10}, 1), 0.2, 1, kTolerance);
  QVERIFY(contact);
  QCOMPARE(contact->u, 0.0);
  QVERIFY(contact->pressing);
}

void FirstContactTest::touchingWeightsAtRestStayOrPart() {
  const Path a = straight({0, 0}, {0, 0}, 1);
  QVERIFY(!core::firstContact(a, straight({0.2, 0}, {0, 0}, 1), 0.2, 1, kTolerance));
  QVERIFY(!core::firstContact(a, thrown({0.2, 0}, {0, 0}, {3, 0}, 1), 0.2, 1, kTolerance));
  // Side by side they fall together.
  QVERIFY(!core::firstContact(thrown({0, 0}, {1, 2}, {0, -10}, 1),
                              thrown({0.2, 0}, {1, 2}, {0, -10}, 1), 0.2, 1, kTolerance));
}

void FirstContactTest::anOffsetWithinRoundingDoesNotPress() {
  for (const double offset : {-3e-13, 3e-13})
    QVERIFY(!core::firstContact(straight({0, 0}, {0, 0}, 1), straight({0.2 + offset, 0}, {0, 0}, 1),
                                0.2, 1, kTolerance));
}

void FirstContactTest::overlappingWeightsMayPart() {
  const Path a = straight({0, 0}, {0, 0}, 1);
  QVERIFY(!core::firstContact(a, straight({0.17, 0}, {0.1, 0}, 1), 0.2, 1, kTolerance));
  const std::optional<Contact> deeper =
      core::firstContact(a, straight({0.17, 0}, {-0.1, 0}, 1), 0.2, 1, kTolerance);
  QVERIFY(deeper);
  QCOMPARE(deeper->u, 0.0);
}

void FirstContactTest::fallsOnAWallAtTheRightMoment() {
  const std::optional<Contact> contact =
      core::firstWallContact(fall(1.25, 0, -10, 2), 0, 2, kTolerance);
  QVERIFY(contact);
  QVERIFY(std::abs(contact->u * 2 - 0.5) < 1e-15);
  QVERIFY(!core::firstWallContact(fall(1.25, 0, -10, 0.4), 0, 0.4, kTolerance));
}

void FirstContactTest::leavesAWallAndReturns() {
  const std::optional<Contact> contact =
      core::firstWallContact(fall(0, 3, -10, 2), 3, 2, kTolerance);
  QVERIFY(contact);
  QVERIFY(!contact->pressing);
  // It has fallen when it is below the wall by the tolerance: 10⁻¹² m at 3 m/s.
  QVERIFY(std::abs(contact->u * 2 - 0.6) < 1e-12);
  QVERIFY(!core::firstWallContact(fall(0, 3, 0, 2), 3, 2, kTolerance));
}

void FirstContactTest::pressesAgainstAWall() {
  const std::optional<Contact> contact =
      core::firstWallContact(fall(0, 0, -10, 2), 0, 2, kTolerance);
  QVERIFY(contact);
  QCOMPARE(contact->u, 0.0);
  QVERIFY(contact->pressing);
}

void FirstContactTest::liesStillAtAWallWithoutAPull() {
  QVERIFY(!core::firstWallContact(fall(0, 0, 0, 2), 0, 2, kTolerance));
  QVERIFY(!core::firstWallContact(fall(1e-13, 0, 0, 2), 0, 2, kTolerance));
}

void FirstContactTest::goesTautAtTheRightMoment() {
  const std::optional<double> moment =
      core::firstTaut(straight({0.3, 0}, {4, 0}, 1), {0, 0}, 1, 1, 0, kTolerance);
  QVERIFY(moment);
  QVERIFY(std::abs(*moment - 0.175) < 1e-15);
}

void FirstContactTest::isTautAtOnceWhenItMovesOutOfItsCircle() {
  const Vector2d place(0, -1);
  QCOMPARE(core::firstTaut(straight(place, {0, -1e-3}, 1), {0, 0}, 1, 1, 0, kTolerance),
           std::optional(0.0));
  // Along the circle, where the rope must pull to keep it there.
  const double outward = outwardAcceleration(place, {2, 0}, 10);
  QVERIFY(outward > 0);
  QCOMPARE(
      core::firstTaut(thrown(place, {2, 0}, {0, -10}, 0.1), {0, 0}, 1, 0.1, outward, kTolerance),
      std::optional(0.0));
}

void FirstContactTest::goesTautAgainAfterMovingIn() {
  // Straight through the circle along its chord.
  const std::optional<double> moment =
      core::firstTaut(straight({-0.6, -0.8}, {1.5, 0}, 1), {0, 0}, 1, 1, 0, kTolerance);
  QVERIFY(moment);
  // Outside by the tolerance of 10⁻¹² m, at 0.9 m/s outwards.
  QVERIFY(std::abs(*moment - 0.8) < 2e-12);
}

void FirstContactTest::goesTautAgainAfterGoingSlack_data() {
  QTest::addColumn<double>("angle");
  QTest::newRow("just above the pivot") << 1.6;
  QTest::newRow("half way up") << 2.3;
  QTest::newRow("near the top") << 3.0;
}

void FirstContactTest::goesTautAgainAfterGoingSlack() {
  QFETCH(double, angle);
  // Where the tension g cos θ + L ω² falls to zero, the parabola touches the circle to third
  // order: |r|² − L² = g t³ (g t / 4 − v_y), so that it is back after 4 v_y / g.
  const double g = 10, speed = std::sqrt(-g * std::cos(angle));
  const Vector2d place(std::sin(angle), -std::cos(angle));
  const Vector2d velocity = speed * Vector2d(std::cos(angle), std::sin(angle));
  const double expected = 4 * velocity.y() / g;
  const double duration = 1.3 * expected;
  const std::optional<double> moment = core::firstTaut(thrown(place, velocity, {0, -g}, duration),
                                                       {0, 0}, 1, duration, 0, kTolerance);
  QVERIFY(moment);
  QVERIFY(std::abs(*moment * duration - expected) < 1e-9);
}

void FirstContactTest::staysSlackWhileItFlies() {
  QVERIFY(!core::firstTaut(straight({0, 0}, {0.9, 0}, 1), {0, 0}, 1, 1, 0, kTolerance));
  QVERIFY(!core::firstTaut(straight({0, -1}, {0, 1}, 1), {0, 0}, 1, 1, 0, kTolerance));
}

QTEST_APPLESS_MAIN(FirstContactTest)
#include "first_contact_test.moc"
