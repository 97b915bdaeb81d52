#include "core/contact/resting.h"

#include <cmath>
#include <vector>

#include <QtTest>

using core::RestingContact;
using core::RestingWeight;

namespace {

constexpr double kDuration = 1.0 / 240;
constexpr core::ContactGoal kGoal{.tolerance = 1e-13, .mostSweeps = 1000};

RestingWeight fallingWeight(double mass) {
  return {.velocity = {0, -9.81 * kDuration}, .mass = mass};
}

RestingContact onFloor(int weight, double friction = 0) {
  return {.a = weight, .normal = {0, 1}, .friction = friction};
}

}  // namespace

class RestingTest : public QObject {
  Q_OBJECT

 private slots:
  void carriesAColumn();
  void startsFromWhatContactsCarry();
  void leavesRoomForTheGap();
  void neverPulls();
  void stopsASlipOrBrakesIt_data();
  void stopsASlipOrBrakesIt();
  void pushesAWeightOnARopeAlongItsTrack();
};

// Each contact of a column carries what lies above it.
void RestingTest::carriesAColumn() {
  constexpr int kHeight = 20;
  std::vector<RestingWeight> weights;
  std::vector<RestingContact> contacts;
  double above = 0;
  for (int i = 0; i < kHeight; ++i) {
    weights.push_back(fallingWeight(0.1 + 0.05 * (i % 3)));
    above += weights.back().mass;
    contacts.push_back(i == 0 ? onFloor(0) : RestingContact{.a = i, .b = i - 1, .normal = {0, 1}});
  }
  QVERIFY(core::solveContacts(weights, contacts, kDuration, kGoal));
  for (int i = 0; i < kHeight; ++i) {
    QVERIFY(weights[i].velocity.norm() < 1e-10);
    QVERIFY(std::abs(contacts[i].push - above * 9.81 * kDuration) < 1e-10);
    above -= weights[i].mass;
  }
}

void RestingTest::startsFromWhatContactsCarry() {
  std::vector<RestingWeight> weights{fallingWeight(2)};
  std::vector<RestingContact> contacts{onFloor(0)};
  contacts[0].push = 2 * 9.81 * kDuration;
  core::applyCarried(weights, contacts);
  QVERIFY(weights[0].velocity.norm() < 1e-16);
  QVERIFY(core::solveContacts(weights, contacts, kDuration, {.tolerance = 1e-13, .mostSweeps = 1}));
  QVERIFY(std::abs(contacts[0].push - 2 * 9.81 * kDuration) < 1e-15);
}

void RestingTest::leavesRoomForTheGap() {
  std::vector<RestingWeight> weights{fallingWeight(2)};
  std::vector<RestingContact> contacts{onFloor(0)};
  contacts[0].gap = 1e-5;
  QVERIFY(core::solveContacts(weights, contacts, kDuration, kGoal));
  QVERIFY(std::abs(weights[0].velocity.y() * kDuration + 1e-5) < 1e-15);
}

void RestingTest::neverPulls() {
  std::vector<RestingWeight> weights{{.velocity = {0, 0.1}, .mass = 2}};
  std::vector<RestingContact> contacts{onFloor(0)};
  QVERIFY(core::solveContacts(weights, contacts, kDuration, kGoal));
  QCOMPARE(contacts[0].push, 0.0);
  QCOMPARE(weights[0].velocity, Eigen::Vector2d(0, 0.1));
}

void RestingTest::stopsASlipOrBrakesIt_data() {
  QTest::addColumn<double>("slip");
  QTest::addColumn<double>("left");
  const double most = 0.2 * 9.81 * kDuration;
  QTest::newRow("slow, to the right") << 0.9 * most << 0.0;
  QTest::newRow("slow, to the left") << -0.9 * most << 0.0;
  QTest::newRow("fast, to the right") << 3 * most << 2 * most;
  QTest::newRow("fast, to the left") << -3 * most << -2 * most;
}

void RestingTest::stopsASlipOrBrakesIt() {
  QFETCH(double, slip);
  QFETCH(double, left);
  std::vector<RestingWeight> weights{fallingWeight(2)};
  weights[0].velocity.x() = slip;
  std::vector<RestingContact> contacts{onFloor(0, 0.2)};
  const std::vector<Eigen::Vector2d> before{weights[0].velocity};
  QVERIFY(core::solveContacts(weights, contacts, kDuration, kGoal));
  QVERIFY(std::abs(weights[0].velocity.x() - left) < 1e-11);
  // Along the floor friction alone changes the weight's energy.
  const double taken = 0.5 * 2 * (slip * slip - left * left);
  QVERIFY(std::abs(core::dragLoss(contacts, before, weights) - taken) < 1e-11);
}

void RestingTest::pushesAWeightOnARopeAlongItsTrack() {
  const double angle = 0.6;
  const Eigen::Vector2d track(std::cos(angle), std::sin(angle));
  std::vector<RestingWeight> weights{{.velocity = -track, .mass = 2, .track = track}};
  std::vector<RestingContact> contacts{{.a = 0, .normal = {1, 0}}};
  QVERIFY(core::solveContacts(weights, contacts, kDuration, kGoal));
  QVERIFY(weights[0].velocity.norm() < 1e-10);
  // An impulse J across the wall changes the speed along the track by J cos(angle)/m.
  QVERIFY(std::abs(contacts[0].push - 2 / std::cos(angle)) < 1e-10);
}

QTEST_APPLESS_MAIN(RestingTest)
#include "resting_test.moc"
