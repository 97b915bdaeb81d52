#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <QtTest>

#include "core/run/run.h"

using core::Run;
using core::Scene;

namespace {

constexpr int kWeights = 5;
constexpr double kAngle = std::numbers::pi / 6;  // of the weights pulled aside
constexpr double kRadius = 0.02;

double pivotOf(int index) {
  return 2 + 2 * kRadius * index;
}

/// Newton's cradle in vacuum, with that many weights pulled to the left.
std::shared_ptr<const Scene> cradle(int pulled) {
  Scene scene;
  scene.airDensity = 0;
  scene.restitution = 1;
  for (int i = 0; i < kWeights; ++i) {
    core::Weight weight;
    weight.radius = kRadius;
    weight.rope = core::Rope{.pivot = {pivotOf(i), 2}, .length = 1};
    if (i < pulled) weight.rope->angle = -kAngle;
    scene.weights.push_back(weight);
  }
  return std::make_shared<const Scene>(std::move(scene));
}

}  // namespace

class CradleTest : public QObject {
  Q_OBJECT

 private slots:
  void handsTheSwingOnThroughTouchingWeights_data();
  void handsTheSwingOnThroughTouchingWeights();
  void onOnePivotOnlyRopesOfNearlyOneLengthLetWeightsMeet_data();
  void onOnePivotOnlyRopesOfNearlyOneLengthLetWeightsMeet();
};

void CradleTest::handsTheSwingOnThroughTouchingWeights_data() {
  QTest::addColumn<QByteArray>("method");
  QTest::addColumn<double>("step");
  QTest::newRow("rk4 at 1/60 s") << QByteArray("rk4") << 1.0 / 60;
  QTest::newRow("rk4 at 1/240 s") << QByteArray("rk4") << 1.0 / 240;
}

void CradleTest::handsTheSwingOnThroughTouchingWeights() {
  QFETCH(QByteArray, method);
  QFETCH(double, step);
  Run run(cradle(1), {.method = method.toStdString(), .step = step});
  const double amplitude = std::sin(kAngle);
  double innermost = 0;
  double lastSwing = 0;  // side that swung out last: −1, +1
  int swings = 0;
  while (run.time() < 20) {
    QCOMPARE(run.advance(), core::RunStatus::kRunning);
    for (int i = 1; i + 1 < kWeights; ++i)
      innermost = std::max(innermost, std::abs(run.weight(i).position.x() - pivotOf(i)));
    const double left = pivotOf(0) - run.weight(0).position.x();
    const double right = run.weight(kWeights - 1).position.x() - pivotOf(kWeights - 1);
    // One out on its side, the other at home.
    if (std::max(left, right) < 0.9 * amplitude) continue;
    QVERIFY(std::min(left, right) < 0.01 * amplitude);
    const double side = left > right ? -1 : 1;
    if (side != lastSwing) ++swings;
    lastSwing = side;
  }
  QVERIFY2(innermost <= 0.01 * amplitude, qPrintable(QString::number(innermost)));
  // A period of 2.04 s: 20 s hold nineteen half swings and the pull at the start.
  QCOMPARE(swings, 20);
}

void CradleTest::onOnePivotOnlyRopesOfNearlyOneLengthLetWeightsMeet_data() {
  QTest::addColumn<QByteArray>("method");
  QTest::addColumn<double>("longer");  // by so much [m]
  QTest::addColumn<bool>("meet");
  for (const char* method : {"euler", "rk4", "dopri5"}) {
    QTest::addRow("%s, nearly one length", method) << QByteArray(method) << 1.9 * kRadius << true;
    QTest::addRow("%s, clear of each other", method)
        << QByteArray(method) << 2.1 * kRadius << false;
  }
}

void CradleTest::onOnePivotOnlyRopesOfNearlyOneLengthLetWeightsMeet() {
  QFETCH(QByteArray, method);
  QFETCH(double, longer);
  QFETCH(bool, meet);
  Scene scene;
  scene.airDensity = 0;
  scene.weights.resize(2);
  scene.weights[0].rope = core::Rope{.pivot = {2, 2}, .length = 1, .angle = -kAngle};
  scene.weights[1].rope = core::Rope{.pivot = {2, 2}, .length = 1 + longer, .angle = kAngle};
  Run run(std::make_shared<const Scene>(scene), {.method = method.toStdString()});
  bool met = false;
  while (run.time() < 2) {
    QCOMPARE(run.advance(), core::RunStatus::kRunning);
    for (const core::Event& event : run.stepEvents())
      met |= event.kind == core::EventKind::kImpactWeight;
  }
  QCOMPARE(met, meet);
}

QTEST_APPLESS_MAIN(CradleTest)
#include "cradle_test.moc"
