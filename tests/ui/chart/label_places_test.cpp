#include "ui/chart/label_places.h"

#include <QTest>

using ui::LabelledCurve;
using ui::labelPlaces;

namespace {

constexpr QRectF kArea(0, 0, 400, 300);
constexpr QSizeF kLabel(80, 20);

bool covers(const QRectF& place, const LabelledCurve& curve) {
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    for (double share = 0; share <= 1; share += 0.01) {
      if (place.contains((1 - share) * curve.points[i - 1] + share * curve.points[i])) return true;
    }
  }
  return false;
}

}  // namespace

class LabelPlacesTest : public QObject {
  Q_OBJECT

 private slots:
  void standsBesideTheLastPoint();
  void staysInside();
  void coversNothing();
  void coversTheLeastWhereThereIsNoRoom();
  void hasNoPlaceWithoutPoints();
};

void LabelPlacesTest::standsBesideTheLastPoint() {
  const auto places = labelPlaces({{{{50, 150}, {200, 150}}, kLabel}}, kArea, 5);
  QCOMPARE(places.front(), QRectF(205, 140, 80, 20));
}

void LabelPlacesTest::staysInside() {
  const auto places = labelPlaces({{{{50, 50}, {395, 295}}, kLabel}}, kArea, 5);
  QVERIFY(kArea.contains(places.front()));
}

void LabelPlacesTest::coversNothing() {
  const std::vector<LabelledCurve> curves{{{{20, 40}, {150, 60}, {300, 90}}, kLabel},
                                          {{{20, 60}, {150, 80}, {300, 110}}, kLabel},
                                          {{{30, 20}, {100, 250}, {330, 280}}, kLabel}};
  const auto places = labelPlaces(curves, kArea, 5);
  for (std::size_t i = 0; i < places.size(); ++i) {
    QVERIFY(kArea.contains(places[i]));
    for (const LabelledCurve& curve : curves) QVERIFY(!covers(places[i], curve));
    for (std::size_t k = 0; k < i; ++k) QVERIFY(!places[i].intersects(places[k]));
  }
}

void LabelPlacesTest::coversTheLeastWhereThereIsNoRoom() {
  const auto places = labelPlaces({{{{20, 10}, {60, 10}}, kLabel}}, QRectF(0, 0, 90, 22), 5);
  QCOMPARE(places.size(), std::size_t{1});
  QVERIFY(!places.front().isEmpty());
}

void LabelPlacesTest::hasNoPlaceWithoutPoints() {
  QVERIFY(labelPlaces({{{}, kLabel}}, kArea, 5).front().isEmpty());
}

QTEST_APPLESS_MAIN(LabelPlacesTest)
#include "label_places_test.moc"
