#include <cmath>
#include <memory>
#include <numbers>

#include <QtTest>

#include "tests/support/fingerprint.h"
#include "tests/support/reference_case.h"

using core::Event;
using core::EventKind;
using core::Phase;
using core::Run;
using core::Scene;
using Eigen::Vector2d;

namespace {

constexpr double kTurning = 2;  // rad/s

/// Weights that circle without gravity and air: both methods are exact.
Scene circling(int count) {
  Scene scene;
  scene.gravity = 0;
  scene.airDensity = 0;
  scene.room = {.width = 20, .height = 4, .restitution = 1, .friction = 0};
  for (int i = 0; i < count; ++i) {
    core::Weight weight;
    weight.rope = core::Rope{
        .pivot = {3 + 3. * i, 2}, .length = 1, .angle = 0.3, .angularVelocity = kTurning};
    scene.weights.push_back(weight);
  }
  return scene;
}

Run runOf(const Scene& scene, double step, const QByteArray& method = "rk4") {
  return Run(std::make_shared<const Scene>(scene), {.method = method.toStdString(), .step = step});
}

/// Where the first circling weight is when its rope was cut at `cut`.
Vector2d placeAfterCut(double cut, double time) {
  const double angle = 0.3 + kTurning * cut;
  return Vector2d(3 + std::sin(angle), 2 - std::cos(angle)) +
         (time - cut) * kTurning * Vector2d(std::cos(angle), std::sin(angle));
}

}  // namespace

class CutTest : public QObject {
  Q_OBJECT

 private slots:
  void fliesOnAlongTheTangentFromInsideAStep_data();
  void fliesOnAlongTheTangentFromInsideAStep();
  void cutByHandOrByTimeIsTheSame_data();
  void cutByHandOrByTimeIsTheSame();
  void cutAtTheStartNeverHangs();
  void cutsOneWeightLooseAlone();
  void listsACutByHandWithTheComingStep();
  void changesNeitherPlaceNorVelocityNorEnergy();
  void letsGoOfASlackRope();
  void listsSeveralEventsOfOneStepInOrder();
};

void CutTest::fliesOnAlongTheTangentFromInsideAStep_data() {
  QTest::addColumn<QByteArray>("method");
  QTest::addColumn<double>("step");
  QTest::addColumn<double>("cut");
  for (const char* method : {"euler", "rk4"}) {
    QTest::addRow("%s, inside", method) << QByteArray(method) << 0.1 << 0.3141;
    QTest::addRow("%s, in the first step", method) << QByteArray(method) << 0.5 << 0.001;
    QTest::addRow("%s, where two steps meet", method) << QByteArray(method) << 0.125 << 0.25;
    QTest::addRow("%s, just before that", method) << QByteArray(method) << 0.125 << 0.25 - 1e-15;
  }
}

void CutTest::fliesOnAlongTheTangentFromInsideAStep() {
  QFETCH(QByteArray, method);
  QFETCH(double, step);
  QFETCH(double, cut);
  Scene scene = circling(1);
  scene.cutTime = cut;
  Run run = runOf(scene, step, method);
  std::vector<Event> events;
  while (run.time() < 0.5) {
    run.advance();
    events.insert(events.end(), run.stepEvents().begin(), run.stepEvents().end());
  }
  QCOMPARE(events.size(), std::size_t{1});
  QCOMPARE(events[0].kind, EventKind::kCut);
  QCOMPARE(events[0].time, cut);
  QCOMPARE(events[0].weight, -1);
  QCOMPARE(run.weight(0).phase, Phase::kFlying);
  QVERIFY(run.allCut());
  QVERIFY((run.weight(0).position - placeAfterCut(cut, run.time())).norm() < 1e-14);
}

void CutTest::cutByHandOrByTimeIsTheSame_data() {
  QTest::addColumn<QByteArray>("method");
  QTest::newRow("euler") << QByteArray("euler");
  QTest::newRow("rk4") << QByteArray("rk4");
}

void CutTest::cutByHandOrByTimeIsTheSame() {
  QFETCH(QByteArray, method);
  Scene scene = *tests::referenceCase("cut-and-bounce").scene;
  scene.cutTime = 57 * (1.0 / 64);
  Run byTime = runOf(scene, 1.0 / 64, method);
  scene.cutTime.reset();
  Run byHand = runOf(scene, 1.0 / 64, method);
  for (int i = 0; i < 200; ++i) {
    if (i == 57) byHand.cutAll();
    byTime.advance();
    byHand.advance();
    QCOMPARE(byHand.weight(0).position, byTime.weight(0).position);
    QCOMPARE(byHand.weight(0).velocity, byTime.weight(0).velocity);
  }
  QCOMPARE(byHand.energies().lostToImpacts, byTime.energies().lostToImpacts);
}

void CutTest::cutAtTheStartNeverHangs() {
  Scene scene = circling(1);
  scene.cutTime = 0;
  Run run = runOf(scene, 0.1);
  QVERIFY(run.allCut());
  QCOMPARE(run.weight(0).phase, Phase::kFlying);
  run.advance();
  QCOMPARE(run.stepEvents().size(), std::size_t{1});
  QCOMPARE(run.stepEvents()[0].kind, EventKind::kCut);
  QCOMPARE(run.stepEvents()[0].time, 0.0);
  QVERIFY((run.weight(0).position - placeAfterCut(0, 0.1)).norm() < 1e-15);
}

void CutTest::cutsOneWeightLooseAlone() {
  Run run = runOf(circling(3), 0.1);
  run.advance();
  run.cut(1);
  run.advance();
  QCOMPARE(run.weight(0).phase, Phase::kTethered);
  QCOMPARE(run.weight(1).phase, Phase::kFlying);
  QCOMPARE(run.weight(2).phase, Phase::kTethered);
  QVERIFY(!run.allCut());
  QVERIFY((run.weight(1).position - Vector2d(3, 0) - placeAfterCut(0.1, 0.2)).norm() < 1e-14);
  run.cut(0);
  run.cut(2);
  QVERIFY(run.allCut());
}

void CutTest::listsACutByHandWithTheComingStep() {
  Run run = runOf(circling(2), 0.1);
  run.advance();
  run.cut(1);
  QVERIFY(run.stepEvents().empty());
  run.advance();
  QCOMPARE(run.stepEvents().size(), std::size_t{1});
  const Event event = run.stepEvents()[0];
  QCOMPARE(event.kind, EventKind::kCut);
  QCOMPARE(event.weight, 1);
  QCOMPARE(event.time, 0.1);
  QVERIFY((event.position - Vector2d(3, 0) - placeAfterCut(0.1, 0.1)).norm() < 1e-15);
  run.advance();
  QVERIFY(run.stepEvents().empty());
}

void CutTest::changesNeitherPlaceNorVelocityNorEnergy() {
  Scene scene = circling(1);
  scene.gravity = 9.81;
  scene.airDensity = 1.2;
  Run run = runOf(scene, 0.02);
  for (int i = 0; i < 15; ++i) run.advance();
  const core::WeightState before = run.weight(0);
  const core::Energies energies = run.energies();
  run.cutAll();
  QCOMPARE(run.weight(0).position, before.position);
  QCOMPARE(run.weight(0).velocity, before.velocity);
  QCOMPARE(run.weight(0).tension, 0.0);
  QCOMPARE(run.energies().accounted(), energies.accounted());
}

void CutTest::letsGoOfASlackRope() {
  Run run = runOf(*tests::referenceCase("rope-goes-slack").scene, 0.1);
  run.advance();
  QCOMPARE(run.weight(0).phase, Phase::kSlack);
  run.cutAll();
  QCOMPARE(run.weight(0).phase, Phase::kFlying);
  // It would go taut at 0.51 s.
  while (run.time() < 1) {
    run.advance();
    for (const Event& event : run.stepEvents()) QCOMPARE(event.kind, EventKind::kCut);
  }
}

void CutTest::listsSeveralEventsOfOneStepInOrder() {
  const tests::ReferenceCase reference = tests::referenceCase("bounce-vacuum");
  Run run = runOf(*reference.scene, 3.5);
  run.advance();
  const auto exact = std::span(reference.exact.events);
  QCOMPARE(run.stepEvents().size(), exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    QCOMPARE(run.stepEvents()[i].kind, exact[i].kind);
    // Nine impacts, each located to 10⁻¹² m at 1 m/s or more.
    QVERIFY(std::abs(run.stepEvents()[i].time - exact[i].time) < 1e-11);
  }
}

QTEST_APPLESS_MAIN(CutTest)
#include "cut_test.moc"
