#include <cmath>
#include <memory>

#include <QtTest>

#include "core/motion/drag.h"
#include "core/run/run.h"

using core::Event;
using core::EventKind;
using core::Phase;
using core::Run;
using core::Scene;
using core::Weight;

namespace {

Scene sceneWith(const Weight& weight) {
  Scene scene;
  scene.airDensity = 0;
  scene.weights = {weight};
  return scene;
}

Weight weightAt(double x, double y, double vx) {
  Weight weight;
  weight.position = {x, y};
  weight.velocity = {vx, 0};
  return weight;
}

/// Runs by Runge–Kutta at 1/60 s; returns what happened.
std::vector<Event> runUntil(Run& run, double time) {
  std::vector<Event> events;
  while (run.time() < time && run.advance() == core::RunStatus::kRunning)
    events.insert(events.end(), run.stepEvents().begin(), run.stepEvents().end());
  return events;
}

Run runOf(const Scene& scene) {
  return Run(std::make_shared<const Scene>(scene), {.method = "rk4", .step = 1.0 / 60});
}

}  // namespace

class RestTest : public QObject {
  Q_OBJECT

 private slots:
  void endsABounceSeriesWhenItsSumSays_data();
  void endsABounceSeriesWhenItsSumSays();
  void neverRestsWhereNothingIsLost();
  void hopsNoLowerThanWhatTouches_data();
  void hopsNoLowerThanWhatTouches();
  void startsAtRestOnTheFloor();
  void slidesToTheRightPlace_data();
  void slidesToTheRightPlace();
  void stopsAtTheRightMomentOfAStep_data();
  void stopsAtTheRightMomentOfAStep();
  void slidesForEverWithoutFriction();
  void bouncesOffAWallWhileItSlides();
};

void RestTest::endsABounceSeriesWhenItsSumSays_data() {
  QTest::addColumn<double>("restitution");
  for (const double restitution : {0.0, 0.3, 0.5, 0.8, 0.95})
    QTest::addRow("%g", restitution) << restitution;
}

void RestTest::endsABounceSeriesWhenItsSumSays() {
  QFETCH(double, restitution);
  const double height = 1;
  Scene scene = sceneWith(weightAt(2, 0.02 + height, 0));
  scene.room.restitution = restitution;
  Run run = runOf(scene);
  // t (1 + 2 e + 2 e² + …), t the fall from the height.
  const double fall = std::sqrt(2 * height / scene.gravity);
  const double end = fall * (1 + restitution) / (1 - restitution);
  const std::vector<Event> events = runUntil(run, end + 1);

  QCOMPARE(events.back().kind, EventKind::kRest);
  QCOMPARE(std::ranges::count(events, EventKind::kRest, &Event::kind), std::ptrdiff_t{1});
  // The last bounce that is left out would rise by 10⁻⁶ of the radius at most, and all that
  // follow it too.
  const double lastSpeed = std::sqrt(2 * scene.gravity * 1e-6 * 0.02);
  const double leftOut = 2 * lastSpeed / scene.gravity / (1 - restitution);
  QVERIFY(events.back().time <= end + 1e-12);
  QVERIFY(events.back().time >= end - leftOut);

  const core::WeightState resting = run.weight(0);
  QCOMPARE(resting.phase, Phase::kResting);
  QCOMPARE(resting.velocity, Eigen::Vector2d(0, 0));
  QCOMPARE(resting.position, Eigen::Vector2d(2, 0.02));
  const core::Energies energies = run.energies();
  const double start = scene.weights[0].mass * scene.gravity * height;
  // Each impact puts the weight right by up to 10⁻¹² m.
  const double rounding = 1e-12 * scene.weights[0].mass * scene.gravity;
  const auto impacts = static_cast<double>(events.size());
  QVERIFY(std::abs(energies.lostToImpacts - start) < rounding * impacts);
  QVERIFY(std::abs(energies.numericalDrift) < rounding * impacts);
}

void RestTest::neverRestsWhereNothingIsLost() {
  Scene scene = sceneWith(weightAt(2, 0.02 + 1e-3, 0));
  scene.room.restitution = 1;
  Run run = runOf(scene);
  const std::vector<Event> events = runUntil(run, 10);
  QCOMPARE(std::ranges::count(events, EventKind::kRest, &Event::kind), std::ptrdiff_t{0});
  // Every 2 √(2 h / g) a bounce, the first after half of that.
  const double between = 2 * std::sqrt(2 * 1e-3 / scene.gravity);
  QCOMPARE(static_cast<long>(events.size()), std::lround(10 / between));
  QVERIFY(std::abs(run.energies().numericalDrift) < 1e-12);
}

void RestTest::hopsNoLowerThanWhatTouches_data() {
  QTest::addColumn<double>("rise");
  QTest::addColumn<bool>("rests");
  QTest::newRow("below 1e-12 m") << 1e-13 << true;
  QTest::newRow("1e-9 m") << 1e-9 << false;
}

// Elastic hops go on for ever: those that cannot be told from touching would fill a step with
// millions of impacts.
void RestTest::hopsNoLowerThanWhatTouches() {
  QFETCH(double, rise);
  QFETCH(bool, rests);
  Scene scene = sceneWith(weightAt(2, 0.02, 0));
  scene.weights[0].velocity.y() = std::sqrt(2 * scene.gravity * rise);
  scene.room.restitution = 1;
  Run run = runOf(scene);
  const std::vector<Event> events = runUntil(run, 0.1);

  const auto hops = std::ranges::count(events, EventKind::kImpactFloor, &Event::kind);
  const int expected = static_cast<int>(0.1 / std::sqrt(8 * rise / scene.gravity));
  QCOMPARE(std::ranges::count(events, EventKind::kRest, &Event::kind), std::ptrdiff_t{rests});
  if (rests)
    QCOMPARE(hops, std::ptrdiff_t{1});
  else
    QVERIFY2(std::abs(hops - expected) < expected / 50, qPrintable(QString::number(hops)));
}

void RestTest::startsAtRestOnTheFloor() {
  Run run = runOf(sceneWith(weightAt(2, 0.02, 0)));
  QVERIFY(runUntil(run, 1).empty());
  QCOMPARE(run.weight(0).phase, Phase::kResting);
  QCOMPARE(run.weight(0).position, Eigen::Vector2d(2, 0.02));
}

void RestTest::slidesToTheRightPlace_data() {
  QTest::addColumn<double>("speed");
  QTest::addColumn<double>("airDensity");
  for (const double speed : {2.0, -1.5, 0.01})
    for (const double airDensity : {0.0, 50.0})
      QTest::addRow("%g m/s in air of %g kg/m³", speed, airDensity) << speed << airDensity;
}

void RestTest::slidesToTheRightPlace() {
  QFETCH(double, speed);
  QFETCH(double, airDensity);
  Scene scene = sceneWith(weightAt(2, 0.02, speed));
  scene.airDensity = airDensity;
  scene.room.friction = 0.3;
  Run run = runOf(scene);
  const double braking = 0.3 * scene.gravity;
  const double q = core::dragFactor(scene.weights[0], airDensity);
  // v v' = −q v² − μ g, integrated over the way and over the time.
  const double way =
      q > 0 ? std::log1p(q * speed * speed / braking) / (2 * q) : speed * speed / (2 * braking);
  const double duration =
      q > 0 ? std::atan(std::abs(speed) * std::sqrt(q / braking)) / std::sqrt(q * braking)
            : std::abs(speed) / braking;
  runUntil(run, duration - 0.1 * duration);
  QVERIFY(duration < 0.1 || run.weight(0).velocity.x() * speed > 0);
  runUntil(run, duration + 1);

  const double place = 2 + std::copysign(way, speed);
  // Without drag the slide is a parabola, exact for the method.
  const double accuracy = q > 0 ? 1e-9 : 1e-14;
  QVERIFY(std::abs(run.weight(0).position.x() - place) < accuracy);
  QCOMPARE(run.weight(0).velocity, Eigen::Vector2d(0, 0));
  QCOMPARE(run.weight(0).phase, Phase::kResting);
  const double friction = scene.weights[0].mass * braking * way;
  QVERIFY(std::abs(run.energies().lostToFriction - friction) < accuracy);
  const double start = 0.5 * scene.weights[0].mass * speed * speed;
  QVERIFY(std::abs(run.energies().lostToAir - (start - friction)) < 10 * accuracy);
}

void RestTest::stopsAtTheRightMomentOfAStep_data() {
  QTest::addColumn<double>("stop");
  for (const double stop : {0.1, 0.4, 0.5, 0.9}) QTest::addRow("%g of a step", stop) << stop;
}

void RestTest::stopsAtTheRightMomentOfAStep() {
  QFETCH(double, stop);
  Scene scene = sceneWith(weightAt(2, 0.02, 0));
  scene.room.friction = 0.3;
  const double braking = 0.3 * scene.gravity, step = 0.5;
  const double speed = braking * stop * step;
  scene.weights[0].velocity = {speed, 0};
  Run run(std::make_shared<const Scene>(scene), {.method = "rk4", .step = step});
  run.advance();
  for (double time = 0; time <= step; time += step / 16) {
    const double sliding = std::min(time, stop * step);
    const double place = 2 + speed * sliding - 0.5 * braking * sliding * sliding;
    QVERIFY(std::abs(run.weightAt(0, time).position.x() - place) < 1e-14);
    QVERIFY(std::abs(run.weightAt(0, time).velocity.x() - (speed - braking * sliding)) < 1e-14);
  }
}

void RestTest::slidesForEverWithoutFriction() {
  Run run = runOf(sceneWith(weightAt(0.5, 0.02, 0.3)));
  QVERIFY(runUntil(run, 10).empty());
  QVERIFY(std::abs(run.weight(0).position.x() - 3.5) < 1e-12);
}

void RestTest::bouncesOffAWallWhileItSlides() {
  Scene scene = sceneWith(weightAt(1, 0.02, -2));
  scene.room.restitution = 0.5;
  Run run = runOf(scene);
  const std::vector<Event> events = runUntil(run, 2);
  QCOMPARE(events.size(), std::size_t{1});
  QCOMPARE(events[0].kind, EventKind::kImpactWest);
  QVERIFY(std::abs(events[0].time - 0.49) < 1e-12);
  QVERIFY(std::abs(run.weight(0).position.x() - (0.02 + run.time() - 0.49)) < 1e-12);
  QCOMPARE(run.weight(0).position.y(), 0.02);
}

QTEST_APPLESS_MAIN(RestTest)
#include "rest_test.moc"
