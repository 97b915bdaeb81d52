#include "ui/chart/curve_cache.h"

#include <limits>

#include <QTest>

using core::TimedPoint;
using ui::CurveCache;

namespace {

struct Sample {
  double time;
  double value;
};

using Series = core::EvenSeries<Sample>;

CurveCache cacheOf(const Series& series) {
  return CurveCache(ui::pointsOf(series, [](const Sample& sample) {
    return TimedPoint{sample.time, sample.time, sample.value};
  }));
}

bool holdsWhatTheSeriesHolds(const CurveCache& cache, const Series& series) {
  const auto samples = series.samples();
  const auto points = cache.points();
  if (points.size() != samples.size()) return false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i] != TimedPoint{samples[i].time, samples[i].time, samples[i].value}) return false;
  }
  return true;
}

}  // namespace

class CurveCacheTest : public QObject {
  Q_OBJECT

 private slots:
  void followsASeriesThroughAppendingThinningAndDropping();
  void hasNoNewsUntilThereAreAny();
  void measuresUpToAMoment();
  void readsBetweenSamples();
};

void CurveCacheTest::followsASeriesThroughAppendingThinningAndDropping() {
  Series series(16);
  CurveCache cache = cacheOf(series);
  for (int i = 0; i < 300; ++i) {
    series.append({double(i), double(i * i)});
    if (i % 7 == 0) continue;  // several at once
    if (i == 120) series.dropAfter(60);
    if (i == 200) series.clear();
    cache.read();
    QVERIFY(holdsWhatTheSeriesHolds(cache, series));
    const double highest = series.samples().empty() ? 0 : series.samples().back().value;
    if (!series.samples().empty()) {
      QVERIFY(cache.extentUntil(1e9).highestY >= highest);
    }
  }
}

void CurveCacheTest::hasNoNewsUntilThereAreAny() {
  Series series(4);
  CurveCache cache = cacheOf(series);
  for (int i = 0; i < 40; ++i) {
    series.append({double(i), 1});
    QVERIFY(cache.hasNews());
    cache.read();
    QVERIFY(!cache.hasNews());
  }
  series.clear();
  QVERIFY(cache.hasNews());
}

void CurveCacheTest::measuresUpToAMoment() {
  Series series(100);
  for (int i = 0; i < 10; ++i) series.append({double(i), double(i)});
  series.append({10, std::numeric_limits<double>::infinity()});
  CurveCache cache = cacheOf(series);
  cache.read();
  QCOMPARE(cache.extentUntil(4).highestY, 4.0);
  QCOMPARE(cache.extentUntil(1e9).highestY, 9.0);
  QCOMPARE(cache.extentUntil(1e9).highestX, 9.0);
  QCOMPARE(cache.extentUntil(2.5).highestX, 2.0);
  QVERIFY(cache.extentUntil(-1).isEmpty());
}

void CurveCacheTest::readsBetweenSamples() {
  Series series(100);
  series.append({1, 10});
  series.append({2, 20});
  series.append({3, std::numeric_limits<double>::quiet_NaN()});
  CurveCache cache = cacheOf(series);
  cache.read();
  QVERIFY(!cache.at(0.9));
  QCOMPARE(cache.at(1)->y, 10.0);
  QCOMPARE(cache.at(1.25)->y, 12.5);
  QCOMPARE(cache.at(1.25)->x, 1.25);
  QCOMPARE(cache.at(2)->y, 20.0);
  QVERIFY(!cache.at(2.5));
  QVERIFY(!cache.at(3));
  QVERIFY(!cache.at(4));
}

QTEST_GUILESS_MAIN(CurveCacheTest)
#include "curve_cache_test.moc"
