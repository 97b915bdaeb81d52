#include "ui/control/weight_drag.h"

#include <cmath>

#include <QLocale>
#include <QTest>

#include "core/scene/angle.h"

using Eigen::Vector2d;
using ui::HandFineness;

class WeightDragTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void stepsSuitTheRoom_data();
  void stepsSuitTheRoom();
  void roundsToShortNumbers();
  void valuesAreAsFineAsAPixel();
  void ropesPointAtTheHandAllRound_data();
  void ropesPointAtTheHandAllRound();
  void snapsToStepsOfTheRoom();
  void ropesTakeOnlyWhatIsAlongTheirCircle();
  void stepsTurnRoundAtTheTop();
  void writesWhatWasSet();
};

void WeightDragTest::stepsSuitTheRoom_data() {
  QTest::addColumn<double>("size");
  QTest::addColumn<double>("length");
  QTest::addColumn<double>("speed");
  QTest::newRow("thimble") << 0.02 << 1e-4 << 0.01;
  QTest::newRow("room") << 3.0 << 0.01 << 0.1;
  QTest::newRow("valley") << 2000.0 << 10.0 << 1.0;
}

void WeightDragTest::stepsSuitTheRoom() {
  QFETCH(double, size);
  const ui::HandSteps steps = ui::handSteps({.width = 2 * size, .height = size});
  QTEST(steps.length, "length");
  QTEST(steps.speed, "speed");
}

void WeightDragTest::roundsToShortNumbers() {
  // To the last bit what a person would type.
  for (int i = -1000; i <= 1000; ++i) {
    const QString typed = QString::number(i) + "e-2";
    QVERIFY(ui::roundedTo(i * 0.01 + 0.004, 0.01) == typed.toDouble());
  }
  QVERIFY(ui::roundedTo(0.26, 0.05) == 0.25);
  QVERIFY(ui::roundedTo(1249, 50) == 1250);
  QVERIFY(!std::signbit(ui::roundedTo(-0.001, 0.01)));
}

void WeightDragTest::valuesAreAsFineAsAPixel() {
  const HandFineness fineness{.length = 0.0087, .speed = 0.033};
  core::Weight weight;
  ui::dragPosition(weight, {1.23456, -0.98765}, fineness);
  QCOMPARE(weight.position, Vector2d(1.235, -0.988));
  ui::dragVelocity(weight, {3.14159, 0.5}, fineness);
  QCOMPARE(weight.velocity, Vector2d(3.14, 0.5));
  core::Rope rope;
  ui::dragLength(rope, {0, -0.876543}, fineness);
  QCOMPARE(rope.length, 0.877);
  ui::dragAngle(rope, {0.3, -0.876543}, fineness);  // a pixel is half a degree wide from there
  QCOMPARE(core::degrees(rope.angle), 18.9);
}

void WeightDragTest::ropesPointAtTheHandAllRound_data() {
  QTest::addColumn<Vector2d>("place");
  QTest::addColumn<double>("degrees");
  QTest::newRow("down") << Vector2d(2, 0) << 0.0;
  QTest::newRow("right") << Vector2d(3, 1) << 90.0;
  QTest::newRow("left") << Vector2d(1, 1) << -90.0;
  QTest::newRow("up") << Vector2d(2, 2) << 180.0;
  QTest::newRow("up to the left") << Vector2d(1, 2) << -135.0;
  QTest::newRow("nowhere") << Vector2d(2, 1) << 180.0;
}

void WeightDragTest::ropesPointAtTheHandAllRound() {
  QFETCH(Vector2d, place);
  core::Rope rope{{2, 1}, 0.7, 0.1, 5, false};
  ui::dragAngle(rope, place, {});
  if (place == rope.pivot) {
    QVERIFY(std::isfinite(rope.angle));
    return;
  }
  QTEST(core::degrees(rope.angle), "degrees");
  QCOMPARE(rope.length, 0.7);
  QCOMPARE(rope.angularVelocity, 5.0);
}

void WeightDragTest::snapsToStepsOfTheRoom() {
  const HandFineness fineness{.snaps = true, .steps = {0.01, 0.1}};
  core::Weight weight;
  ui::dragPosition(weight, {1.23456, 0.58}, fineness);
  QCOMPARE(weight.position, Vector2d(1.25, 0.6));
  ui::dragVelocity(weight, {3.14159, -0.3}, fineness);
  QCOMPARE(weight.velocity, Vector2d(3, -0.5));
  weight.rope = core::Rope{};
  ui::dragAngle(*weight.rope, {0.3, -0.876543}, fineness);  // 18.9°
  QCOMPARE(core::degrees(weight.rope->angle), 20.0);
}

void WeightDragTest::ropesTakeOnlyWhatIsAlongTheirCircle() {
  core::Weight weight;
  weight.rope = core::Rope{{0, 0}, 2, core::radians(90), 0, false};  // at the right: up is along
  ui::dragVelocity(weight, {7, 3}, {.speed = 1e-9});
  QVERIFY(std::abs(weight.rope->angularVelocity - 1.5) < 1e-9);  // rounded to 10⁻⁹ m/s
}

void WeightDragTest::stepsTurnRoundAtTheTop() {
  core::Weight weight;
  weight.rope = core::Rope{};
  weight.rope->angle = core::radians(179.5);
  ui::nudge(weight, {1, 0}, {0.01, 0.1});
  QCOMPARE(core::degrees(weight.rope->angle), -179.5);
  ui::nudge(weight, {-1, 0}, {0.01, 0.1});
  QCOMPARE(core::degrees(weight.rope->angle), 179.5);
}

void WeightDragTest::writesWhatWasSet() {
  core::Weight weight;
  weight.position = {0.5, -1.25};
  weight.velocity = {3, 0};
  QCOMPARE(ui::positionWords(weight), QString("x 0.5 m, y −1.25 m"));
  QCOMPARE(ui::velocityWords(weight), QString("vx 3 m/s, vy 0 m/s"));
  weight.rope = core::Rope{{0, 0}, 1.5, core::radians(-70), core::radians(45), false};
  QCOMPARE(ui::angleWords(*weight.rope), QString("Angle −70°"));
  QCOMPARE(ui::lengthWords(*weight.rope), QString("Length 1.5 m"));
  QCOMPARE(ui::velocityWords(weight), QString("45 °/s"));
}

QTEST_GUILESS_MAIN(WeightDragTest)
#include "weight_drag_test.moc"
