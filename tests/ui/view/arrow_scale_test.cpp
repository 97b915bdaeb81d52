#include "ui/view/arrow_scale.h"

#include <cmath>

#include <QTest>

#include "core/scene/scene.h"

class ArrowScaleTest : public QObject {
  Q_OBJECT

 private slots:
  void suitsTheWeightsAndTheRoom();
  void staysRound_data();
  void staysRound();
  void knowsScenesWithoutGravity();
  void hasAScaleForAnEmptyScene();
};

void ArrowScaleTest::suitsTheWeightsAndTheRoom() {
  core::Scene scene;
  scene.weights.resize(2);
  scene.weights[1].mass = 1;
  const ui::ArrowScales scales = ui::arrowScales(scene);
  QCOMPARE(scales.force, 10.0);  // up to 1.5 times 9.81 N
  QCOMPARE(scales.speed, 2.0);   // up to half of √(9.81 · 3) m/s
  scene.weights[0].velocity = {0, 30};
  QCOMPARE(ui::arrowScales(scene).speed, 10.0);
  QCOMPARE(scales.pixelsPerForce(), ui::kReferenceLength / 10);
}

void ArrowScaleTest::staysRound_data() {
  QTest::addColumn<double>("mass");
  for (const double mass : {1e-6, 3e-5, 0.0011, 0.19, 7.0, 1e3, 6e8})
    QTest::addRow("%g kg", mass) << mass;
}

void ArrowScaleTest::staysRound() {
  QFETCH(double, mass);
  core::Scene scene;
  scene.weights.resize(1);
  scene.weights[0].mass = mass;
  const double force = ui::arrowScales(scene).force;
  const double digit = force / std::pow(10, std::floor(std::log10(force) + 1e-9));
  QVERIFY(std::abs(digit - 1) < 1e-9 || std::abs(digit - 2) < 1e-9 || std::abs(digit - 5) < 1e-9);
  // Gravity is neither a stump nor a spear: 1.5 down to 1.5/2.5 times the reference, inverted.
  const double length = ui::kReferenceLength * mass * 9.81 / force;
  QVERIFY2(length > 39 && length < 101, qPrintable(QString::number(length)));
}

void ArrowScaleTest::knowsScenesWithoutGravity() {
  core::Scene scene;
  scene.gravity = 0;
  scene.airDensity = 0;
  core::Weight turning;
  turning.mass = 2;
  turning.rope = core::Rope{{2, 2}, 0.5, 0, 4, false};  // 2 m/s on 0.5 m: 16 N
  scene.weights = {turning};
  QCOMPARE(ui::arrowScales(scene).force, 20.0);
  QCOMPARE(ui::arrowScales(scene).speed, 1.0);
}

void ArrowScaleTest::hasAScaleForAnEmptyScene() {
  core::Scene scene;
  scene.gravity = 0;
  QCOMPARE(ui::arrowScales(scene), (ui::ArrowScales{1, 1}));
}

QTEST_GUILESS_MAIN(ArrowScaleTest)
#include "arrow_scale_test.moc"
