#include "core/aim/landing_finder.h"

#include <cmath>

#include <QtTest>

#include "tests/support/landings.h"
#include "tests/support/random_scene.h"
#include "tests/support/reference_case.h"

using core::EventKind;
using core::FirstHit;
using core::Landing;
using core::LandingFinder;
using core::LandingOutcome;
using tests::landingIn;

namespace {

constexpr double kWait = 4;  // [s]

/// The first impact of the weight on the floor after the cut, in a run from the start.
std::optional<core::Event> landingOf(core::Scene scene, const core::Solver& solver, int weight,
                                     double cutTime) {
  scene.cutTime = cutTime;
  core::Run run(std::make_shared<const core::Scene>(scene), solver);
  bool isCut = false;
  while (run.time() <= cutTime + kWait && run.advance() == core::RunStatus::kRunning) {
    for (const core::Event& event : run.stepEvents()) {
      if (isCut && event.kind == EventKind::kImpactFloor && event.weight == weight) return event;
      isCut = isCut || event.kind == EventKind::kCut;
    }
  }
  return std::nullopt;
}

LandingFinder finderFor(const core::Scene& scene, const core::Solver& solver, int weight,
                        double until) {
  return tests::finderFor(scene, solver, weight, until, kWait);
}

core::Scene hangingStill() {
  core::Scene scene;
  scene.airDensity = 0;
  scene.weights.resize(1);
  scene.weights[0].rope = core::Rope{.pivot = {2, 2.5}, .length = 1};
  return scene;
}

}  // namespace

class LandingFinderTest : public QObject {
  Q_OBJECT

 private slots:
  void findsToTheBitWhatARunFromTheStartShows_data();
  void findsToTheBitWhatARunFromTheStartShows();
  void isExactWhereTheAnswerIsKnown();
  void tellsWhatWasHitFirst();
  void theHistoryHoldsOnlyWhatMatters();
  void waitsOnlySoLong();
  void aWeightOnTheFloorHasLanded();
  void endsWhereTheRunCannotGoOn();
  void endsWhenItIsTold();
};

void LandingFinderTest::findsToTheBitWhatARunFromTheStartShows_data() {
  QTest::addColumn<core::Solver>("solver");
  QTest::addRow("rk4") << core::Solver{.method = "rk4"};
  QTest::addRow("euler") << core::Solver{.method = "euler", .step = 1.0 / 100};
  QTest::addRow("dopri5") << core::Solver{.method = "dopri5", .step = 1.0 / 20};
}

void LandingFinderTest::findsToTheBitWhatARunFromTheStartShows() {
  QFETCH(core::Solver, solver);
  int landed = 0;
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    const core::Scene scene = tests::randomScene(seed, 4);
    const LandingFinder finder = finderFor(scene, solver, 1, 2);
    // At the start, within steps, at their ends, and a hair beside them.
    for (const double cutTime : {0.0, 1e-9, 0.1234, solver.step, 7 * solver.step,
                                 std::nextafter(7 * solver.step, 9), 2.0}) {
      const Landing landing = landingIn(finder, cutTime);
      const auto expected = landingOf(scene, solver, 1, cutTime);
      if (!expected) continue;
      ++landed;
      QCOMPARE(landing.outcome, LandingOutcome::kLanded);
      QCOMPARE(landing.cutTime, cutTime);
      QVERIFY(landing.place == expected->position.x());
      QVERIFY(landing.time == expected->time);
    }
  }
  QVERIFY(landed > 20);
}

void LandingFinderTest::isExactWhereTheAnswerIsKnown() {
  const auto known = tests::referenceCase("cut-and-bounce");
  const auto impact =
      std::ranges::find(known.exact.events, EventKind::kImpactFloor, &core::Event::kind);
  const LandingFinder finder =
      finderFor(*known.scene, {.method = "rk4", .step = 1.0 / 240}, impact->weight, 3);
  const Landing landing = landingIn(finder, *known.scene->cutTime);
  // The README states 10⁻⁶ at three times that step, and errors fall with its 4th power.
  QVERIFY(std::abs(landing.place - impact->position.x()) < 1e-7);
  QVERIFY(std::abs(landing.time - impact->time) < 1e-7);
}

void LandingFinderTest::tellsWhatWasHitFirst() {
  core::Scene scene = hangingStill();
  const core::Solver solver{.method = "rk4"};
  QCOMPARE(landingIn(finderFor(scene, solver, 0, 1), 0.5).firstHit, FirstHit::kNothing);
  scene.weights[0].rope->angularVelocity = 5;
  scene.room.width = 2.5;
  QCOMPARE(landingIn(finderFor(scene, solver, 0, 1), 0.05).firstHit, FirstHit::kWall);
  scene = hangingStill();
  scene.weights.push_back(scene.weights[0]);
  scene.weights[1].rope.reset();
  scene.weights[1].position = {1.5, 0.5};
  QCOMPARE(landingIn(finderFor(scene, solver, 0, 1), 0.0).firstHit, FirstHit::kNothing);
  scene.weights[1].position = {2, 0.02};  // it lies on the floor, right below
  QCOMPARE(landingIn(finderFor(scene, solver, 0, 1), 0.0).firstHit, FirstHit::kWeight);
}

void LandingFinderTest::theHistoryHoldsOnlyWhatMatters() {
  core::Scene scene = hangingStill();
  core::Weight bystander;  // bounces in a corner
  bystander.position = {0.5, 0.4};
  scene.weights.push_back(bystander);
  const LandingFinder finder = finderFor(scene, {.method = "rk4"}, 0, 2);
  const std::uint64_t early = landingIn(finder, 0.1).history;
  QCOMPARE(landingIn(finder, 2).history, early);
  scene.weights[1].position = {1.9, 1.5};  // flies into the weight while that hangs
  scene.weights[1].velocity = {1, 0.2};
  const LandingFinder hit = finderFor(scene, {.method = "rk4"}, 0, 2);
  QVERIFY(landingIn(hit, 0).history != landingIn(hit, 0.5).history);
}

void LandingFinderTest::waitsOnlySoLong() {
  core::Scene scene = hangingStill();
  scene.gravity = 0;
  const LandingFinder finder = finderFor(scene, {.method = "rk4"}, 0, 1);
  QCOMPARE(landingIn(finder, 0.5).outcome, LandingOutcome::kNotInTime);
}

void LandingFinderTest::aWeightOnTheFloorHasLanded() {
  core::Scene scene = hangingStill();
  scene.weights[0].rope.reset();
  scene.weights[0].position = {1.25, scene.weights[0].radius};
  const LandingFinder finder = finderFor(scene, {.method = "rk4"}, 0, 1);
  QCOMPARE(landingIn(finder, 0.5).outcome, LandingOutcome::kLanded);
  QCOMPARE(landingIn(finder, 0.5).place, 1.25);
}

void LandingFinderTest::endsWhereTheRunCannotGoOn() {
  const core::Scene scene = tests::beyondNumbers(hangingStill());
  const LandingFinder finder = finderFor(scene, {.method = "euler", .step = 0.1}, 0, 5);
  QVERIFY(finder.hungUntil() < 5);
}

void LandingFinderTest::endsWhenItIsTold() {
  core::WorkMeter meter(1, [](double) { return false; });
  LandingFinder finder(hangingStill(), {.method = "rk4", .step = 1e-4}, 0, 1e9);
  QVERIFY(!finder.hangUntil(1e9, meter));
  core::Scene scene = hangingStill();
  scene.gravity = 0;
  QVERIFY(!LandingFinder(scene, {.method = "rk4"}, 0, 1e9).landing(0, meter));
}

QTEST_APPLESS_MAIN(LandingFinderTest)
#include "landing_finder_test.moc"
