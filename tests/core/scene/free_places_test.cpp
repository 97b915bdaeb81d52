#include "core/scene/free_places.h"

#include <limits>

#include <QtTest>

#include "core/scene/scene_limits.h"

using core::Scene;

namespace {

Scene roomOf(double width, double height) {
  Scene scene;
  scene.room.width = width;
  scene.room.height = height;
  return scene;
}

core::Weight freeWeight(double x, double y, double radius) {
  core::Weight weight;
  weight.position = {x, y};
  weight.radius = radius;
  return weight;
}

}  // namespace

class FreePlacesTest : public QObject {
  Q_OBJECT

 private slots:
  void startsBesideTheModel();
  void goesOnUpwardsAndThenFromTheFloor();
  void avoidsOtherWeights();
  void givesWhatThereIs_data();
  void givesWhatThereIs();
  void findsAHundredThousandAmongAsMany();
};

void FreePlacesTest::startsBesideTheModel() {
  Scene scene = roomOf(4, 3);
  scene.weights = {freeWeight(1, 2, 0.1)};
  const auto places = core::freePlaces(scene, scene.weights[0], 2);
  QCOMPARE(places.size(), std::size_t{2});
  QVERIFY(places[0].isApprox(Eigen::Vector2d(1.25, 2)));
  QVERIFY(places[1].isApprox(Eigen::Vector2d(1.5, 2)));
}

void FreePlacesTest::goesOnUpwardsAndThenFromTheFloor() {
  // Two columns and three rows; the model stands in the middle row on the right.
  Scene scene = roomOf(0.5, 0.75);
  scene.weights = {freeWeight(0.375, 0.375, 0.1)};
  const auto places = core::freePlaces(scene, scene.weights[0], 10);
  QCOMPARE(places.size(), std::size_t{5});
  QVERIFY(places[0].isApprox(Eigen::Vector2d(0.125, 0.625)));
  QVERIFY(places[1].isApprox(Eigen::Vector2d(0.375, 0.625)));
  QVERIFY(places[2].isApprox(Eigen::Vector2d(0.125, 0.125)));
  QVERIFY(places[4].isApprox(Eigen::Vector2d(0.125, 0.375)));
}

void FreePlacesTest::avoidsOtherWeights() {
  Scene scene = roomOf(4, 3);
  scene.weights = {freeWeight(1.3, 2, 0.1), freeWeight(3, 1, 0.9), freeWeight(1, 2, 0.1)};
  const core::Weight model = scene.weights.back();
  for (const auto& place : core::freePlaces(scene, model, 60)) {
    scene.weights.push_back(freeWeight(place.x(), place.y(), model.radius));
  }
  QCOMPARE(scene.weights.size(), std::size_t{63});
  QVERIFY(core::problemsIn(scene).empty());
}

void FreePlacesTest::givesWhatThereIs_data() {
  QTest::addColumn<double>("x");
  QTest::addColumn<double>("radius");
  QTest::newRow("filled by the model") << 0.5 << 0.5;
  QTest::newRow("a model outside") << -7.0 << 0.1;
  QTest::newRow("a model nowhere") << std::numeric_limits<double>::quiet_NaN() << 0.1;
  QTest::newRow("a model without size") << 0.5 << 0.0;
}

void FreePlacesTest::givesWhatThereIs() {
  QFETCH(double, x);
  QFETCH(double, radius);
  Scene scene = roomOf(1, 1);
  scene.weights = {freeWeight(x, 0.5, radius)};
  QVERIFY(core::freePlaces(scene, scene.weights[0], 3).empty());
}

void FreePlacesTest::findsAHundredThousandAmongAsMany() {
  Scene scene = roomOf(100, 100);
  for (int i = 0; i < core::kMostWeights; ++i) {
    const int row = i / 499;
    const int column = i % 499;
    scene.weights.push_back(freeWeight(0.1 + 0.2 * column, 0.1 + 0.2 * row, 0.05));
  }
  const auto places = core::freePlaces(scene, scene.weights.front(), core::kMostWeights);
  QCOMPARE(places.size(), std::size_t{core::kMostWeights});
}

QTEST_APPLESS_MAIN(FreePlacesTest)
#include "free_places_test.moc"
