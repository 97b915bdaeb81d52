#include "core/run/step_stages.h"

#include <cmath>
#include <memory>
#include <numbers>

#include <QtTest>

#include "core/motion/drag.h"
#include "core/run/run.h"

using core::Entries;
using core::Run;
using core::Scene;
using core::Stage;
using core::StepPart;

namespace {

constexpr double kRestAngle = std::numbers::pi / 6;  // 30°: its sine is 1/2
constexpr double kRounding = 1e-14;

/// A weight let go at 30° from a rope of 1 m without air, under g = 10 m/s²: θ'' = −10 sin θ.
Scene hanging() {
  Scene scene;
  scene.gravity = 10;
  scene.airDensity = 0;
  core::Weight weight;
  weight.rope = core::Rope{.pivot = {2, 2.5}, .length = 1, .angle = kRestAngle};
  scene.weights = {weight};
  return scene;
}

/// A weight that flies with (3, 4) m/s, so at 5 m/s, through air that brakes it with
/// 0.1/m times the square of its speed, under g = 10 m/s².
Scene flying() {
  Scene scene;
  scene.gravity = 10;
  core::Weight weight;
  weight.mass = 1;
  weight.position = {1, 1};
  weight.velocity = {3, 4};
  scene.airDensity = 0.1 / core::dragFactor(weight, 1);
  scene.weights = {weight};
  return scene;
}

Run runOf(const Scene& scene, const std::string& method, double step) {
  return Run(std::make_shared<const Scene>(scene), {.method = method, .step = step});
}

bool near(const Entries& entries, const Entries& expected, double tolerance = kRounding) {
  return (entries - expected).abs().maxCoeff() <= tolerance;
}

Entries entriesOf(double a, double b, double c, double d, double e = 0) {
  Entries entries;
  entries << a, b, c, d, e;
  return entries;
}

}  // namespace

/// One step of one weight, opened up.
class StepStagesTest : public QObject {
  Q_OBJECT

 private slots:
  void opensAnEulerStepWorkedByHand();
  void opensARungeKuttaStepWorkedByHand();
  void opensASemiImplicitStepWorkedByHand();
  void placesTheStagesInTheRoom();
  void theMeanOfTheSlopesLeadsToTheEnd_data();
  void theMeanOfTheSlopesLeadsToTheEnd();
  void anEventDividesTheStep();
  void showsTheComingStepAsItWillBe();
  void retakesThePartByAnotherMethod();
  void aWeightAtRestHasNoStages();
  void theReferenceTakesNoSlopes();
  void lookingInsideChangesNothing();
};

void StepStagesTest::opensAnEulerStepWorkedByHand() {
  Run run = runOf(flying(), "euler", 0.1);
  run.advance();
  const std::vector<StepPart> parts = run.latestStep(0);
  QCOMPARE(parts.size(), std::size_t{1});
  QCOMPARE(parts[0].begin, 0.0);
  QCOMPARE(parts[0].end, 0.1);
  QCOMPARE(parts[0].stages.size(), std::size_t{1});
  const Stage& first = parts[0].stages[0];
  QCOMPARE(first.node, 0.0);
  QCOMPARE(first.share, std::optional<double>(1));
  QVERIFY(near(first.state, entriesOf(1, 1, 3, 4)));
  // q |v| = 0.1 · 5 = 0.5: v_x' = −0.5 · 3 = −1.5, v_y' = −10 − 0.5 · 4 = −12,
  // Q' = m q |v|³ = 1 · 0.1 · 125 = 12.5.
  QVERIFY(near(first.slope, entriesOf(3, 4, -1.5, -12, 12.5)));
  // A tenth of that is added.
  QVERIFY(near(parts[0].endState, entriesOf(1.3, 1.4, 2.85, 2.8, 1.25)));
}

void StepStagesTest::opensARungeKuttaStepWorkedByHand() {
  Run run = runOf(hanging(), "rk4", 0.1);
  run.advance();
  const std::vector<StepPart> parts = run.latestStep(0);
  QCOMPARE(parts.size(), std::size_t{1});
  const std::vector<Stage>& stages = parts[0].stages;
  QCOMPARE(stages.size(), std::size_t{4});

  // k1 at (π/6, 0):             θ' = 0,     ω' = −10 · 1/2 = −5
  QVERIFY(near(stages[0].state, entriesOf(kRestAngle, 0, 0, 0)));
  QVERIFY(near(stages[0].slope, entriesOf(0, 0, -5, 0)));
  // k2 half a step along k1, at (π/6, −0.25):           θ' = −0.25, ω' = −5
  QVERIFY(near(stages[1].state, entriesOf(kRestAngle, 0, -0.25, 0)));
  QVERIFY(near(stages[1].slope, entriesOf(-0.25, 0, -5, 0)));
  // k3 half a step along k2, at (π/6 − 0.0125, −0.25):  θ' = −0.25,
  //   ω' = −10 (1/2 cos 0.0125 − √3/2 sin 0.0125)
  //      = −10 (0.5 · 0.9999218760 − 0.8660254038 · 0.0124996745) = −4.8913590
  QVERIFY(near(stages[2].state, entriesOf(kRestAngle - 0.0125, 0, -0.25, 0)));
  QVERIFY(near(stages[2].slope, entriesOf(-0.25, 0, -4.8913590, 0), 1e-7));
  // k4 a whole step along k3, at (π/6 − 0.025, −0.48913590): θ' = −0.48913590,
  //   ω' = −10 (0.5 · 0.9996875163 − 0.8660254038 · 0.0249973959) = −4.7819538
  QVERIFY(near(stages[3].state, entriesOf(kRestAngle - 0.025, 0, -0.4891359, 0), 1e-8));
  QVERIFY(near(stages[3].slope, entriesOf(-0.4891359, 0, -4.7819538, 0), 1e-7));

  // The mean: θ' = (0 + 2 · (−0.25) + 2 · (−0.25) − 0.4891359)/6 = −0.24818932,
  // ω' = (−5 − 10 − 2 · 4.8913590 − 4.7819538)/6 = −4.9274453.
  QVERIFY(near(parts[0].meanSlope(), entriesOf(-0.24818932, 0, -4.9274453, 0), 1e-7));
  QVERIFY(near(parts[0].endState, entriesOf(kRestAngle - 0.024818932, 0, -0.49274453, 0), 1e-8));

  const double nodes[] = {0, 0.5, 0.5, 1};
  const double sixths[] = {1, 2, 2, 1};
  for (int i = 0; i < 4; ++i) {
    QCOMPARE(stages[i].node, nodes[i]);
    QVERIFY(std::abs(6 * stages[i].share.value() - sixths[i]) < kRounding);
  }
}

void StepStagesTest::opensASemiImplicitStepWorkedByHand() {
  Run run = runOf(hanging(), "semi-implicit-euler", 0.1);
  run.advance();
  const StepPart part = run.latestStep(0)[0];
  QCOMPARE(part.stages.size(), std::size_t{1});
  QVERIFY(near(part.stages[0].slope, entriesOf(0, 0, -5, 0)));
  // The new rate, −5 · 0.1 = −0.5, turns it by −0.05: no mean of slopes at the start does.
  QVERIFY(!part.stages[0].share);
  QVERIFY(near(part.endState, entriesOf(kRestAngle - 0.05, 0, -0.5, 0)));
  QVERIFY(near(part.meanSlope(), entriesOf(-0.5, 0, -5, 0), 1e-12));
}

void StepStagesTest::placesTheStagesInTheRoom() {
  Run run = runOf(hanging(), "rk4", 0.1);
  run.advance();
  const StepPart part = run.latestStep(0)[0];
  // The pivot is at (2, 2.5), the weight 1 m from it at 30°.
  const double cosine = std::sqrt(3) / 2;
  QVERIFY((part.beginPosition - Eigen::Vector2d(2.5, 2.5 - cosine)).norm() < kRounding);
  QCOMPARE(part.endPosition, run.weight(0).position);
  // At the second stage it is still there, and moves with −0.25 m/s along (cos 30°, sin 30°).
  QVERIFY((part.stages[1].position - part.beginPosition).norm() < kRounding);
  QVERIFY((part.stages[1].velocity + 0.25 * Eigen::Vector2d(cosine, 0.5)).norm() < kRounding);
}

void StepStagesTest::theMeanOfTheSlopesLeadsToTheEnd_data() {
  QTest::addColumn<int>("index");
  for (std::size_t i = 0; i < core::methods().size(); ++i)
    QTest::newRow(std::string(core::methods()[i].id).c_str()) << static_cast<int>(i);
}

void StepStagesTest::theMeanOfTheSlopesLeadsToTheEnd() {
  QFETCH(int, index);
  const core::Method& method = core::methods()[static_cast<std::size_t>(index)];
  for (const Scene& scene : {hanging(), flying()}) {
    Run run = runOf(scene, std::string(method.id), 0.01);
    run.advance();
    const StepPart part = run.latestStep(0).back();  // an adaptive method takes several
    QCOMPARE(static_cast<int>(part.stages.size()), method.slopesPerStep);
    QCOMPARE(part.endPosition, run.weight(0).position);
    if (!part.stages[0].share) continue;
    Entries mean = Entries::Zero();
    double shares = 0;
    for (const Stage& stage : part.stages) {
      mean += *stage.share * stage.slope;
      shares += *stage.share;
    }
    QVERIFY(std::abs(shares - 1) < kRounding);
    QVERIFY(near(part.meanSlope(), mean, 1e-12));
  }
}

void StepStagesTest::anEventDividesTheStep() {
  Scene scene = flying();
  scene.airDensity = 0;
  // 0.2 m above the floor at 4 m/s downwards, it hits after 0.0472 s and flies up again.
  scene.weights[0].position = {1, 0.2 + scene.weights[0].radius};
  scene.weights[0].velocity = {0, -4};
  Run run = runOf(scene, "rk4", 0.1);
  run.advance();
  const double hit = (-4 + std::sqrt(16 + 2 * 10 * 0.2)) / 10;
  const std::vector<StepPart> parts = run.latestStep(0);
  QCOMPARE(parts.size(), std::size_t{2});
  QCOMPARE(parts[0].begin, 0.0);
  QVERIFY(std::abs(parts[0].end - hit) < 1e-12);
  QCOMPARE(parts[1].begin, parts[0].end);
  QCOMPARE(parts[1].end, 0.1);
  QVERIFY(parts[0].endState[3] < 0 && parts[1].beginState[3] > 0);
  for (const StepPart& part : parts) QCOMPARE(part.stages.size(), std::size_t{4});
}

void StepStagesTest::showsTheComingStepAsItWillBe() {
  Scene scene = flying();
  scene.weights[0].position.y() = 0.1;
  scene.weights[0].velocity.y() = -4;
  Run run = runOf(scene, "rk4", 0.1);
  QVERIFY(run.latestStep(0).empty());
  const std::vector<StepPart> foreseen = run.nextStep(0);
  QCOMPARE(run.stepCount(), 0);
  run.advance();
  const std::vector<StepPart> taken = run.latestStep(0);
  QCOMPARE(foreseen.size(), std::size_t{2});
  QCOMPARE(taken.size(), std::size_t{2});
  for (int i = 0; i < 2; ++i) {
    QCOMPARE(foreseen[i].end, taken[i].end);
    QVERIFY((foreseen[i].endState == taken[i].endState).all());
  }
}

void StepStagesTest::retakesThePartByAnotherMethod() {
  Run run = runOf(flying(), "rk4", 0.1);
  run.advance();
  const StepPart part = run.latestStep(0)[0];
  const StepPart byEuler = run.retaken(0, part, *core::findMethod("euler"));
  QCOMPARE(byEuler.begin, part.begin);
  QCOMPARE(byEuler.end, part.end);
  QVERIFY(near(byEuler.endState, entriesOf(1.3, 1.4, 2.85, 2.8, 1.25)));
  const StepPart again = run.retaken(0, part, run.method());
  QVERIFY((again.endState == part.endState).all());
}

void StepStagesTest::aWeightAtRestHasNoStages() {
  Scene scene = flying();
  scene.weights[0].position = {1, scene.weights[0].radius};
  scene.weights[0].velocity = {0, 0};
  Run run = runOf(scene, "rk4", 0.1);
  run.advance();
  const std::vector<StepPart> parts = run.latestStep(0);
  QCOMPARE(parts.size(), std::size_t{1});
  QVERIFY(parts[0].stages.empty());
}

void StepStagesTest::theReferenceTakesNoSlopes() {
  Run run = runOf(hanging(), "reference", 0.1);
  run.advance();
  QVERIFY(!run.latestStep(0).empty());
  for (const StepPart& part : run.latestStep(0)) QVERIFY(part.stages.empty());
  QCOMPARE(run.latestStep(0).back().endPosition, run.weight(0).position);
}

void StepStagesTest::lookingInsideChangesNothing() {
  Run looked = runOf(hanging(), "rk4", 0.01);
  Run alone = runOf(hanging(), "rk4", 0.01);
  for (int i = 0; i < 100; ++i) {
    looked.nextStep(0);
    looked.advance();
    looked.latestStep(0);
    alone.advance();
  }
  QCOMPARE(looked.weight(0).position, alone.weight(0).position);
  QCOMPARE(looked.slopeEvaluations(), alone.slopeEvaluations());
}

QTEST_APPLESS_MAIN(StepStagesTest)
#include "step_stages_test.moc"
