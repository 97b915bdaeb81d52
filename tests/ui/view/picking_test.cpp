#include "ui/view/picking.h"

#include <QTest>

#include "tests/ui/view/example_scenes.h"

class PickingTest : public QObject {
  Q_OBJECT

 private slots:
  void takesTheNearestWithinReach();
  void takesTheOneInFront();
  void seesTheOutlinesOfOtherRuns();
  void staysCheapInCrowds();
  void takesSmallWeightsOfACrowdAsTheyAreDrawn();
  void velocitiesAreHeldAtTheTipOrBeside();
};

void PickingTest::takesTheNearestWithinReach() {
  const ui::ShownScene shown = example::freeWeights(3, 1e-4, 0);
  const ui::Camera camera = example::camera(shown);
  const QPointF center = camera.toPixels(shown.scene.weights[1].position);
  // Too small to be seen as large as it is, it is drawn with a radius of 3 px.
  QCOMPARE(ui::weightNear(shown, camera, center + QPointF(0, 14.9)), 1);
  QCOMPARE(ui::weightNear(shown, camera, center + QPointF(0, 15.1)), std::nullopt);
}

void PickingTest::takesTheOneInFront() {
  ui::ShownScene shown = example::freeWeights(2, 0.02, 0);
  shown.scene.weights[0].radius = 0.5;
  for (ui::ShownRun& run : shown.runs) run.weights[0].position = run.weights[1].position;
  const ui::Camera camera = example::camera(shown);
  const QPointF center = camera.toPixels(shown.runs[0].weights[1].position);
  QCOMPARE(ui::weightNear(shown, camera, center), 1);
  QCOMPARE(ui::weightNear(shown, camera, center + QPointF(30, 0)), 0);
}

void PickingTest::seesTheOutlinesOfOtherRuns() {
  const ui::ShownScene shown = example::freeWeights(2, 0.02, 0.4);
  const ui::Camera camera = example::camera(shown);
  const QPointF outline = camera.toPixels(shown.runs[1].weights[1].position);
  QCOMPARE(ui::weightNear(shown, camera, outline), 1);
  const ui::ShownScene without = example::freeWeights(2, 0.02, 0);
  QCOMPARE(ui::weightNear(without, camera, outline), std::nullopt);
}

void PickingTest::staysCheapInCrowds() {
  const ui::ShownScene shown = example::freeWeights(10000, 1e-4, 0);
  const ui::Camera camera = example::camera(shown);
  const QPointF center = camera.toPixels(shown.scene.weights[6789].position);
  QCOMPARE(ui::weightNear(shown, camera, center), 6789);
}

void PickingTest::takesSmallWeightsOfACrowdAsTheyAreDrawn() {
  ui::ShownScene shown = example::freeWeights(501, 1e-4, 0);
  const ui::Camera camera = example::camera(shown);
  // All but one lie in a corner; with so many the least radius drawn is 1.5 px.
  for (ui::ShownRun& run : shown.runs)
    for (core::WeightState& weight : run.weights) weight.position = {0, 0};
  const QPointF alone(camera.toPixels(Eigen::Vector2d(2, 1)));
  for (ui::ShownRun& run : shown.runs) run.weights[7].position = camera.toMetres(alone);
  QCOMPARE(ui::weightNear(shown, camera, alone + QPointF(0, 13.4)), 7);
  QCOMPARE(ui::weightNear(shown, camera, alone + QPointF(0, 13.6)), std::nullopt);
}

void PickingTest::velocitiesAreHeldAtTheTipOrBeside() {
  const ui::Camera camera = example::camera(example::freeWeights(1, 0.02, 0));
  const ui::ArrowScales scales{.speed = 1, .force = 1};
  core::Weight weight;
  weight.position = {2, 1};
  const QPointF center = camera.toPixels(weight.position);
  weight.velocity = {3, 4};
  // 5 m/s at 60 px for 1 m/s, up on the screen
  const QPointF tip = ui::velocityGrip(weight, scales, camera) - center;
  QVERIFY((tip - QPointF(180, -240)).manhattanLength() < 1e-6);
  weight.velocity = {0, 0};
  const QPointF beside = ui::velocityGrip(weight, scales, camera) - center;
  QVERIFY(beside.x() > weight.radius * camera.scale() + ui::kPickReach && beside.y() == 0);
  weight.rope = core::Rope{{2, 2}, 1, std::acos(0.0), 0, false};  // level: its circle leads up
  const QPointF along = ui::velocityGrip(weight, scales, camera) - camera.toPixels({3, 2});
  QVERIFY(std::abs(along.x()) < 1e-6 && along.y() < 0);
}

QTEST_MAIN(PickingTest)
#include "picking_test.moc"
