#include "core/trade/stability_map.h"

#include <cmath>

#include <QtTest>

using core::Boundedness;
using core::MapQuantity;
using core::StabilityMap;

namespace {

core::Scene pendulum() {
  core::Scene scene;
  scene.airDensity = 0;
  scene.weights.resize(2);
  scene.weights[0].rope = core::Rope{.pivot = {1, 2.5}, .length = 1, .angle = 0.5};
  scene.weights[1].rope = core::Rope{.pivot = {3, 2.5}, .length = 0.5, .angle = 0.5};
  return scene;
}

/// The largest step that stays bounded, together with all smaller ones.
double limitOf(const StabilityMap& map, std::size_t value) {
  double limit = 0;
  for (std::size_t i = 0; i < map.steps.size(); ++i) {
    if (map.cell(i, value)->outcome != Boundedness::kBounded) break;
    limit = map.steps[i];
  }
  return limit;
}

}  // namespace

class StabilityMapTest : public QObject {
  Q_OBJECT

 private slots:
  void shorterRopesNeedShorterSteps();
  void isTheSameAsSingleTrials();
  void leavesOutScenesThatCannotBe();
  void changesAllRopesInProportion();
  void changesTheAir();
  void needsRopesForRopeLengths();
  void endsWhenItIsTold();
};

void StabilityMapTest::shorterRopesNeedShorterSteps() {
  const auto map =
      core::stabilityMap(pendulum(), *core::findMethod("rk4"), MapQuantity::kRopeLength, 10);
  const std::size_t present = 12, short16 = 4;  // 2^(i/2 − 6) of the present length
  QVERIFY(std::abs(map->values[present] - 1) < 1e-12);
  QVERIFY(std::abs(map->values[short16] - 1.0 / 16) < 1e-12);
  // The time scale of a swing is √(L/g): a sixteenth of the length, a quarter of the step. The
  // shorter one swings through four times as many periods, and steps stand √2 apart.
  const double ratio = limitOf(*map, present) / limitOf(*map, short16);
  QVERIFY2(2.8 < ratio && ratio < 8.1, qPrintable(QString::number(ratio)));
}

void StabilityMapTest::isTheSameAsSingleTrials() {
  const auto map =
      core::stabilityMap(pendulum(), *core::findMethod("euler"), MapQuantity::kRopeLength, 3);
  core::WorkMeter meter(1, {});
  for (const std::size_t step : {0U, 7U, 20U}) {
    const auto scene = std::make_shared<const core::Scene>(
        core::withQuantity(pendulum(), MapQuantity::kRopeLength, map->values[10]));
    const auto trial =
        core::boundednessOf(scene, {.method = "euler", .step = map->steps[step]}, 3, meter);
    QCOMPARE(map->cell(step, 10)->outcome, trial->outcome);
    QCOMPARE(map->cell(step, 10)->drift, trial->drift);
  }
}

void StabilityMapTest::leavesOutScenesThatCannotBe() {
  const auto map =
      core::stabilityMap(pendulum(), *core::findMethod("rk4"), MapQuantity::kRopeLength, 0.1);
  QVERIFY(map->cell(0, 14));   // 2 m: 1.76 m down in a room of 3 m
  QVERIFY(!map->cell(0, 15));  // 2.83 m: through the wall beside the pivot
  QVERIFY(!map->cell(20, 16));
}

void StabilityMapTest::changesAllRopesInProportion() {
  const core::Scene changed = core::withQuantity(pendulum(), MapQuantity::kRopeLength, 2);
  QCOMPARE(changed.weights[0].rope->length, 2.0);
  QCOMPARE(changed.weights[1].rope->length, 1.0);
}

void StabilityMapTest::changesTheAir() {
  QCOMPARE(core::withQuantity(pendulum(), MapQuantity::kAirDensity, 7).airDensity, 7.0);
  const auto map =
      core::stabilityMap(pendulum(), *core::findMethod("euler"), MapQuantity::kAirDensity, 5);
  QCOMPARE(map->values.front(), 0.1);
  QCOMPARE(map->values.back(), 2000.0);
  // Air takes energy, so that Euler's swing runs away at larger steps only.
  QVERIFY(limitOf(*map, map->values.size() - 1) > limitOf(*map, 0));
}

void StabilityMapTest::needsRopesForRopeLengths() {
  core::Scene scene;
  scene.weights.resize(1);
  scene.weights[0].position = {1, 1};
  QVERIFY(!core::canBeMapped(scene, MapQuantity::kRopeLength));
  QVERIFY(core::canBeMapped(scene, MapQuantity::kAirDensity));
  QVERIFY(core::canBeMapped(pendulum(), MapQuantity::kRopeLength));
}

void StabilityMapTest::endsWhenItIsTold() {
  int calls = 0;
  const auto map = core::stabilityMap(pendulum(), *core::findMethod("rk4"),
                                      MapQuantity::kRopeLength, 10, [&](double done) {
                                        ++calls;
                                        return done < 0.2;
                                      });
  QVERIFY(!map);
  QVERIFY(calls < 400);
}

QTEST_APPLESS_MAIN(StabilityMapTest)
#include "stability_map_test.moc"
