#include "ui/chart/chart_kind.h"

#include <cmath>
#include <numbers>
#include <set>

#include <QTest>

#include "tests/ui/chart/recorded_scene.h"
#include "ui/chart/curve_cache.h"
#include "ui/style/theme.h"

using ui::ChartContent;
using ui::ChartCurve;
using ui::CurveStyle;

namespace {

ChartContent contentOf(const char* id, const ui::ChartSubject& subject) {
  for (const ui::ChartKind& kind : ui::chartKinds()) {
    if (qstrcmp(kind.id, id) == 0) return kind.content(subject, ui::Theme::light());
  }
  qFatal("no kind %s", id);
}

std::vector<core::TimedPoint> pointsOf(const ChartCurve& curve) {
  std::vector<core::TimedPoint> points;
  curve.points->appendFrom(0, points);
  return points;
}

std::vector<core::TimedPoint> amountsOf(const ChartCurve& curve) {
  std::vector<core::TimedPoint> points;
  curve.amounts->appendFrom(0, points);
  return points;
}

constexpr double kCut = 0.4;  // [s]

}  // namespace

class ChartKindTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void listsEachKindOnce();
  void drawsOneCurveForEachWeightAndRun();
  void drawsHeightAndSpeedOfTheWeight();
  void drawsPathsAsPlaces();
  void drawsAnglesOnlyWhileARopeIsTaut();
  void stacksTheLedgerUpToTheEnergyAtTheStartAndItsDrift();
  void drawsFurtherRunsOfTheStackAsLines();
  void tellsWeightsApartByColorAndAloneByRun();
  void saysHowManyWeightsItShows();
};

void ChartKindTest::listsEachKindOnce() {
  std::set<QString> names;
  for (const ui::ChartKind& kind : ui::chartKinds()) names.insert(kind.name());
  QCOMPARE(names.size(), ui::chartKinds().size());
  QCOMPARE(names, (std::set<QString>{"Energy", "Ledger", "Phase", "Paths", "Height", "Speed"}));
}

void ChartKindTest::drawsOneCurveForEachWeightAndRun() {
  RecordedScene scene(3, kCut, {{.method = "rk4"}, {.method = "euler"}});
  for (const char* id : {"phase", "paths", "height", "speed"}) {
    QCOMPARE(contentOf(id, scene.subject({0, 1, 2})).curves.size(), std::size_t{6});
    QCOMPARE(contentOf(id, scene.subject({2})).curves.size(), std::size_t{2});
  }
}

void ChartKindTest::drawsHeightAndSpeedOfTheWeight() {
  RecordedScene scene(3, kCut, {{.method = "rk4"}});
  scene.runUntil(1);
  const core::WeightState now = scene.run(0).weight(1);
  const auto height = pointsOf(contentOf("height", scene.subject({1})).curves[0]);
  const auto speed = pointsOf(contentOf("speed", scene.subject({1})).curves[0]);
  QCOMPARE(height.size(), std::size_t{61});
  QCOMPARE(height.back().x, scene.run(0).time());
  QCOMPARE(height.back().y, now.position.y());
  QCOMPARE(speed.back().y, now.velocity.norm());
}

void ChartKindTest::drawsPathsAsPlaces() {
  RecordedScene scene(3, kCut, {{.method = "rk4"}});
  scene.runUntil(1);
  const ChartContent content = contentOf("paths", scene.subject({2}));
  const auto path = pointsOf(content.curves[0]);
  QVERIFY(!content.overTime);
  QCOMPARE(path.back().time, scene.run(0).time());
  QCOMPARE(path.back().x, scene.run(0).weight(2).position.x());
  QCOMPARE(path.back().y, scene.run(0).weight(2).position.y());
}

void ChartKindTest::drawsAnglesOnlyWhileARopeIsTaut() {
  RecordedScene scene(1, kCut, {{.method = "rk4"}});
  scene.runUntil(0.2);
  const core::WeightState swinging = scene.run(0).weight(0);
  scene.runUntil(1);
  const auto portrait = pointsOf(contentOf("phase", scene.subject({0})).curves[0]);
  QVERIFY(std::abs(portrait[0].x - 60) < 1e-9);
  QCOMPARE(portrait[0].y, 0.0);
  QCOMPARE(portrait[12].time, 0.2);
  QVERIFY(std::abs(portrait[12].x - swinging.angle * 180 / std::numbers::pi) < 1e-9);
  QVERIFY(std::abs(portrait[12].y - swinging.angularVelocity * 180 / std::numbers::pi) < 1e-9);
  for (const core::TimedPoint& point : portrait) {
    QCOMPARE(std::isfinite(point.x), point.time < kCut);
    QCOMPARE(std::isfinite(point.y), point.time < kCut);
  }
}

void ChartKindTest::stacksTheLedgerUpToTheEnergyAtTheStartAndItsDrift() {
  RecordedScene scene(3, kCut, {{.method = "euler"}});
  scene.runUntil(3);
  const ChartContent content = contentOf("ledger", scene.subject({}));
  const core::Energies now = scene.run(0).energies();
  const auto curves = std::span(content.curves).first(6);
  double top = 0;
  for (const ChartCurve& curve : curves) {
    QCOMPARE(curve.style, CurveStyle::kBand);
    top += amountsOf(curve).back().y;
    QVERIFY(std::abs(pointsOf(curve).back().y - top) < 1e-12);
  }
  QVERIFY(std::abs(top - now.accounted()) < 1e-12);

  const ChartCurve& drift = content.curves[6];
  QCOMPARE(drift.style, CurveStyle::kHatched);
  QVERIFY(std::abs(drift.base - scene.run(0).startEnergy()) < 1e-12);
  QVERIFY(std::abs(pointsOf(drift).back().y - drift.base - now.numericalDrift) < 1e-12);
  QCOMPARE(amountsOf(drift).back().y, now.numericalDrift);
  QVERIFY(now.numericalDrift > 0.01);  // or this test would show nothing
}

void ChartKindTest::drawsFurtherRunsOfTheStackAsLines() {
  RecordedScene scene(3, kCut, {{.method = "rk4"}, {.method = "euler"}});
  for (const ChartCurve& curve : contentOf("ledger", scene.subject({})).curves) {
    const bool isDrift = curve.name == "Numerical drift";
    const bool isStart = curve.name == "At the start";
    QCOMPARE(curve.style == CurveStyle::kHatched, isDrift);
    QCOMPARE(curve.style == CurveStyle::kBand, curve.run == 0 && !isDrift && !isStart);
  }
}

void ChartKindTest::tellsWeightsApartByColorAndAloneByRun() {
  RecordedScene scene(3, kCut, {{.method = "rk4"}, {.method = "euler"}});
  const ChartContent all = contentOf("height", scene.subject({0, 1, 2}));
  QVERIFY(all.curves[0].color != all.curves[1].color);
  QCOMPARE(all.curves[0].color, all.curves[3].color);  // the same weight in the other run
  const ChartContent alone = contentOf("height", scene.subject({1}));
  QCOMPARE(alone.curves[0].color, ui::Theme::light().runs[0]);
  QCOMPARE(alone.curves[1].color, ui::Theme::light().runs[1]);
}

void ChartKindTest::saysHowManyWeightsItShows() {
  RecordedScene scene(30, kCut, {{.method = "rk4"}});
  std::vector<int> first(core::MotionLog::kMostFromStart);
  for (std::size_t i = 0; i < first.size(); ++i) first[i] = static_cast<int>(i);
  QCOMPARE(contentOf("height", scene.subject(first)).note, QString("The first 24 of 30 weights"));
  QCOMPARE(contentOf("height", scene.subject({3})).note, QString());
}

QTEST_GUILESS_MAIN(ChartKindTest)
#include "chart_kind_test.moc"
