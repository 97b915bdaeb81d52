#include <cmath>
#include <memory>
#include <numbers>

#include <QtTest>

#include "tests/bench/peers/discs.h"
#include "tests/bench/peers/pendulum.h"
#include "tests/support/billiard.h"
#include "tests/support/crowd.h"
#include "tests/support/reference_case.h"

using bench::ExactPendulum;
using bench::Pendulum;
using bench::PendulumSolver;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// The case's one weight as a pendulum.
Pendulum pendulumOf(const core::Scene& scene) {
  const core::Weight& weight = scene.weights[0];
  const double area = std::numbers::pi * weight.radius * weight.radius;
  return {.angle = weight.rope->angle,
          .drag = scene.airDensity * weight.dragCoefficient * area * weight.rope->length /
                  (2 * weight.mass),
          .pull = scene.gravity / weight.rope->length,
          .length = weight.rope->length};
}

core::Scene fallingBall() {
  core::Scene scene;
  scene.airDensity = 0;
  scene.restitution = scene.room.restitution = 1;
  core::Weight weight;
  weight.position = {1, 2};
  weight.velocity = {0.5, 0};
  scene.weights.push_back(weight);
  return scene;
}

}  // namespace

/// That the benchmark sets the same problem to everybody.
class PeersTest : public QObject {
  Q_OBJECT

 private slots:
  void knowsWhereAPendulumIs_data();
  void knowsWhereAPendulumIs();
  void letsEverySolverSolveTheSamePendulum_data();
  void letsEverySolverSolveTheSamePendulum();
  void findsTheCoarsestSettingThatIsGoodEnough();
  void letsEveryEngineThrowTheSameBall_data();
  void letsEveryEngineThrowTheSameBall();
  void letsEveryEngineStartWithTheSameCrowd_data();
  void letsEveryEngineStartWithTheSameCrowd();

 private:
  void addEngines();
};

void PeersTest::knowsWhereAPendulumIs_data() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"pendulum-vacuum-60", "pendulum-vacuum-120", "pendulum-air"})
    QTest::addRow("%s", name) << name;
}

void PeersTest::knowsWhereAPendulumIs() {
  QFETCH(QString, name);
  const tests::ReferenceCase reference = tests::referenceCase(name);
  const ExactPendulum pendulum(pendulumOf(*reference.scene));
  // Degrees in the files end at 16 digits: at 120° these are 3·10⁻¹⁶ rad, and as much again is
  // lost where the release is given in degrees.
  for (const tests::Moment& moment : reference.exact.moments)
    QVERIFY(std::abs(pendulum.at(moment.time) - moment.weights[0].angle) < 2e-14);
}

void PeersTest::letsEverySolverSolveTheSamePendulum_data() {
  QTest::addColumn<int>("solver");
  QTest::addColumn<double>("drag");
  const std::vector<PendulumSolver> solvers = bench::allSolvers();
  for (int i = 0; i < static_cast<int>(solvers.size()); ++i)
    for (const double drag : {0.0, 0.0226}) {
      // Without events its polynomials mean nothing beyond a turning point in air.
      if (drag > 0 && solvers[i].name == "reference") continue;
      QTest::addRow("%s, drag %g", solvers[i].name.c_str(), drag) << i << drag;
    }
}

void PeersTest::letsEverySolverSolveTheSamePendulum() {
  QFETCH(int, solver);
  QFETCH(double, drag);
  const PendulumSolver who = bench::allSolvers()[solver];
  const Pendulum pendulum{.angle = 120 * kDegree, .drag = drag};
  const ExactPendulum exact(pendulum);
  const double coarse = who.takesTolerance ? 1e-7 : 15;
  const double fine = who.takesTolerance ? 1e-9 : 60;
  const double error = largestError(who, pendulum, exact, fine);
  // In ten seconds errors grow, most where high orders meet the kinks of drag; another problem
  // would be off by 10⁻² rad.
  QVERIFY2(error > 0 && error < 1e-5, qPrintable(QString::number(error)));
  QVERIFY(error < largestError(who, pendulum, exact, coarse) / 2);
}

void PeersTest::findsTheCoarsestSettingThatIsGoodEnough() {
  const Pendulum pendulum{.angle = 120 * kDegree, .drag = 0};
  const ExactPendulum exact(pendulum);
  const PendulumSolver rungeKutta = bench::allSolvers()[0];
  const double rate = settingFor(rungeKutta, pendulum, exact, 1e-6);
  QVERIFY(largestError(rungeKutta, pendulum, exact, rate) <= 1e-6);
  QVERIFY(largestError(rungeKutta, pendulum, exact, std::floor(rate / 1.1)) > 1e-6);
}

void PeersTest::addEngines() {
  QTest::addColumn<int>("engine");
  const std::vector<bench::Engine> engines = bench::crowdEngines();
  for (int i = 0; i < static_cast<int>(engines.size()); ++i)
    QTest::addRow("%s", engines[i].name.c_str()) << i;
}

void PeersTest::letsEveryEngineThrowTheSameBall_data() {
  addEngines();
}

void PeersTest::letsEveryEngineThrowTheSameBall() {
  QFETCH(int, engine);
  const core::Scene scene = fallingBall();
  const bench::Engine who = bench::crowdEngines()[engine];
  bench::WorldOptions options = who.options;
  options.mayRest = false;
  const auto world = who.make(scene, options);
  for (int i = 0; i < 30; ++i) world->step();
  // Engines step by Euler's method: half a step of fall, 4 cm, is theirs.
  QVERIFY(std::abs(world->position(0).x() - 1.25) < 1e-3);
  QVERIFY(std::abs(world->position(0).y() - (2 - 9.81 / 8)) < 0.05);
  QVERIFY(std::abs(world->velocity(0).y() + 9.81 / 2) < 1e-3);
  QCOMPARE(world->impacts(), 0);
  for (int i = 0; i < 30; ++i) world->step();
  // Thrown back by the floor where the floor is.
  QVERIFY(world->impacts() > 0);
  QVERIFY(world->velocity(0).y() > 0);
  QVERIFY(world->position(0).y() > scene.weights[0].radius);
}

void PeersTest::letsEveryEngineStartWithTheSameCrowd_data() {
  addEngines();
}

void PeersTest::letsEveryEngineStartWithTheSameCrowd() {
  QFETCH(int, engine);
  core::Scene scene = tests::crowd(10);
  scene.airDensity = 0;
  const bench::Engine who = bench::crowdEngines()[engine];
  const auto world = who.make(scene, who.options);
  double start = 0;
  for (const core::Weight& weight : scene.weights)
    start += weight.mass * weight.velocity.squaredNorm() / 2;
  // Numbers of seven digits in Box2D.
  QVERIFY(std::abs(kineticEnergy(scene, *world) / start - 1) < 1e-5);
  QCOMPARE(largestOverlap(scene, *world), 0.0);
  for (int i = 0; i < 60; ++i) world->step();
  // All of them fell to the floor, and none out of the room.
  for (int i = 0; i < 10; ++i) {
    QVERIFY(0 < world->position(i).y() && world->position(i).y() < scene.room.height);
    QVERIFY(0 < world->position(i).x() && world->position(i).x() < scene.room.width);
  }
}

QTEST_APPLESS_MAIN(PeersTest)
#include "peers_test.moc"
