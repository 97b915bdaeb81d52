#include <cmath>
#include <memory>

#include <QtTest>

#include "core/run/run.h"

using core::EventKind;
using core::Run;
using core::Scene;
using core::Weight;

namespace {

constexpr double kSpeed = 1;     // of the heavy disc [m/s]
constexpr double kUntil = 6;     // all impacts are over by then [s]
constexpr double kLight = 0.01;  // mass [kg]

/// Galperin's billiard: a heavy disc drives a light one against the west wall.
std::shared_ptr<const Scene> billiard(double massRatio) {
  Scene scene;
  scene.gravity = 0;
  scene.airDensity = 0;
  scene.room = {.width = 10, .height = 3, .restitution = 1, .friction = 0};
  scene.weights.resize(2);
  Weight& light = scene.weights[0];
  Weight& heavy = scene.weights[1];
  light.mass = kLight;
  light.radius = 0.02;
  light.position = {0.5, 1.5};
  heavy.mass = kLight * massRatio;
  heavy.radius = 0.1;
  heavy.position = {1.5, 1.5};
  heavy.velocity = {-kSpeed, 0};
  return std::make_shared<const Scene>(std::move(scene));
}

/// Exact x of the heavy disc after `time`.
///
/// With a and b the free ways of the two to the wall, (√m a, √M b) moves like a point of
/// light between two mirrors at an angle α = atan √(m/M): on a straight line when the
/// mirrored wedges are unfolded next to each other.
double exactPlace(const Scene& scene, double time) {
  const Weight& light = scene.weights[0];
  const Weight& heavy = scene.weights[1];
  const long double rootRatio = std::sqrt(static_cast<long double>(light.mass) / heavy.mass);
  const double behind = heavy.radius + 2 * light.radius;
  const long double across = rootRatio * (light.position.x() - light.radius);
  const long double along = heavy.position.x() - behind - kSpeed * time;
  const long double alpha = std::atan(rootRatio);
  const long double folded = std::fmod(std::atan2(across, along), 2 * alpha);
  const long double angle = std::min(folded, 2 * alpha - folded);
  return static_cast<double>(std::hypot(across, along) * std::cos(angle)) + behind;
}

}  // namespace

class BilliardTest : public QObject {
  Q_OBJECT

 private slots:
  void countsTheDigitsOfPi_data();
  void countsTheDigitsOfPi();
};

void BilliardTest::countsTheDigitsOfPi_data() {
  QTest::addColumn<QByteArray>("method");
  QTest::addColumn<double>("massRatio");
  QTest::addColumn<int>("impacts");
  for (const std::string method : {"semi-implicit-euler", "rk4", "dopri5", "reference"}) {
    const auto row = [&](const char* ratio, double massRatio, int impacts) {
      QTest::addRow("%s, %s", ratio, method.c_str())
          << QByteArray::fromStdString(method) << massRatio << impacts;
    };
    row("1", 1e0, 3);
    row("100", 1e2, 31);
    row("10⁴", 1e4, 314);
    row("10⁶", 1e6, 3141);
    row("10⁸", 1e8, 31415);
    row("10¹⁰", 1e10, 314159);
  }
}

void BilliardTest::countsTheDigitsOfPi() {
  QFETCH(QByteArray, method);
  QFETCH(double, massRatio);
  QFETCH(int, impacts);
  Run run(billiard(massRatio), {.method = method.toStdString(), .step = 1.0 / 60});
  int counted = 0;
  while (run.time() < kUntil) {
    QCOMPARE(run.advance(), core::RunStatus::kRunning);
    for (const core::Event& event : run.stepEvents())
      if (event.kind == EventKind::kImpactWeight || event.kind == EventKind::kImpactWest) ++counted;
  }
  QCOMPARE(counted, impacts);
  QVERIFY(std::abs(run.weight(1).position.x() - exactPlace(run.scene(), run.time())) < 1e-9);
  // Each impact rounds the light disc's energy once.
  QVERIFY(std::abs(run.energies().numericalDrift) < 1e-15 * impacts * run.startEnergy());
}

QTEST_APPLESS_MAIN(BilliardTest)
#include "billiard_test.moc"
