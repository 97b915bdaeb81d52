#include "ui/chart/energy_chart.h"

#include <algorithm>

#include <QChart>
#include <QLineSeries>
#include <QPointer>
#include <QSignalSpy>
#include <QTest>
#include <QTranslator>
#include <QValueAxis>

#include "tests/ui/chart/sample_ledgers.h"

using core::Ledger;
using ui::EnergyChart;
using ui::Theme;

namespace {

const QLineSeries* curveNamed(const EnergyChart& chart, const QString& name) {
  for (const QAbstractSeries* series : chart.chart()->series()) {
    if (series->name() == name) return qobject_cast<const QLineSeries*>(series);
  }
  return nullptr;
}

const QValueAxis* axis(const EnergyChart& chart, Qt::Orientation orientation) {
  return qobject_cast<const QValueAxis*>(chart.chart()->axes(orientation).constFirst());
}

double highestOf(const QLineSeries& curve) {
  double highest = 0;
  for (const QPointF& point : curve.points()) highest = std::max(highest, point.y());
  return highest;
}

QColor cornerOf(EnergyChart& chart) {
  return chart.grab().toImage().pixelColor(2, 2);
}

/// A chart on the screen, as it redraws only where it is seen.
class ShownChart : public EnergyChart {
 public:
  explicit ShownChart(QSize size = QSize(640, 400)) {
    resize(size);
    show();
  }
};

}  // namespace

class EnergyChartTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }
  void curvesAreTheLedgers();
  void drawsTheRunsByLineStyleAndTheQuantitiesByColor();
  void keepsPeaksWithAFewPoints();
  void staysSmallAfterAnHour();
  void putsBothRunsOnOneScale();
  void growsWithTheRun();
  void catchesUpWithTheLatestSample();
  void leavesCurvesAloneWhenNothingChanged();
  void drawsWhatItMissedWhileHidden();
  void startsAnewWithTheLedger();
  void showsRopesOnceTheyLoseEnergy();
  void switchesThemeLive();
  void followsThePalette();
  void followsTheLanguage();
  void drawsNothingYet_data();
  void drawsNothingYet();
  void survivesADivergedRun();
  void fillsItsWindowAtAnySize();
  void leavesNothingBehind();
};

void EnergyChartTest::curvesAreTheLedgers() {
  Ledger ledger;
  ledger.append({0, {3, 2, 0, 0, 0, 0, 0}});
  ledger.append({1, {1, 2, 0.5, 0.25, 0.125, 0.0625, -1.0625}});
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});

  using Points = QList<QPointF>;
  QCOMPARE(curveNamed(chart, "Kinetic, RK4")->points(), (Points{{0, 3}, {1, 1}}));
  QCOMPARE(curveNamed(chart, "Potential, RK4")->points(), (Points{{0, 2}, {1, 2}}));
  QCOMPARE(curveNamed(chart, "Lost to air, RK4")->points(), (Points{{0, 0}, {1, 0.5}}));
  QCOMPARE(curveNamed(chart, "Lost to impacts, RK4")->points(), (Points{{0, 0}, {1, 0.25}}));
  QCOMPARE(curveNamed(chart, "Lost to ropes, RK4")->points(), (Points{{0, 0}, {1, 0.125}}));
  QCOMPARE(curveNamed(chart, "Lost to friction, RK4")->points(), (Points{{0, 0}, {1, 0.0625}}));
  QCOMPARE(curveNamed(chart, "Total, RK4")->points(), (Points{{0, 5}, {1, 3.9375}}));
}

void EnergyChartTest::drawsTheRunsByLineStyleAndTheQuantitiesByColor() {
  const Ledger ledger = sample_ledgers::swinging(2, 201);
  ShownChart chart;
  chart.setTheme(Theme::light());
  chart.setRuns({{&ledger, "RK4"}, {&ledger, "Euler"}});

  const QPen first = curveNamed(chart, "Kinetic, RK4")->pen();
  const QPen second = curveNamed(chart, "Kinetic, Euler")->pen();
  QCOMPARE(first.style(), Qt::SolidLine);
  QCOMPARE(second.style(), Qt::CustomDashLine);
  QCOMPARE(first.color(), Theme::light().kinetic);
  QCOMPARE(second.color(), Theme::light().kinetic);
}

void EnergyChartTest::keepsPeaksWithAFewPoints() {
  Ledger ledger = sample_ledgers::swinging(10, 30000);
  core::Energies peak;
  peak.kinetic = 7;
  ledger.append({10.0001, peak});
  ledger.append({10.0002, core::Energies()});
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});

  for (const char* name : {"Kinetic, RK4", "Potential, RK4", "Total, RK4"}) {
    QVERIFY(curveNamed(chart, name)->count() <= 2000);
    QVERIFY(curveNamed(chart, name)->count() > 1000);
  }
  QCOMPARE(highestOf(*curveNamed(chart, "Kinetic, RK4")), 7.0);
}

void EnergyChartTest::staysSmallAfterAnHour() {
  const Ledger first = sample_ledgers::swinging(3600, 3600 * 60);
  const Ledger second = sample_ledgers::swinging(3600, 3600 * 60, 1, 1e-4);
  ShownChart chart;
  chart.setRuns({{&first, "RK4"}, {&second, "Euler"}});

  int points = 0;
  for (const QAbstractSeries* series : chart.chart()->series()) {
    points += qobject_cast<const QLineSeries*>(series)->count();
  }
  QVERIFY(points <= 10000);
  // Dashes along thousands of swings would take most of the time.
  QCOMPARE(curveNamed(chart, "Kinetic, Euler")->pen().style(), Qt::SolidLine);
  QCOMPARE(curveNamed(chart, "Total, Euler")->pen().style(), Qt::CustomDashLine);
  QCOMPARE(axis(chart, Qt::Horizontal)->max(), 4000.0);
}

void EnergyChartTest::putsBothRunsOnOneScale() {
  const Ledger steady = sample_ledgers::swinging(4, 401);
  const Ledger gaining = sample_ledgers::swinging(4, 401, 1, 2);  // to 11 J
  ShownChart chart;
  chart.setRuns({{&steady, "RK4"}, {&gaining, "Euler"}});

  QCOMPARE(chart.chart()->axes().size(), 2);
  QVERIFY(axis(chart, Qt::Vertical)->max() >= 11);
  for (QAbstractSeries* series : chart.chart()->series()) {
    QCOMPARE(series->attachedAxes().size(), 2);
  }
}

void EnergyChartTest::growsWithTheRun() {
  Ledger ledger;
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});
  QSignalSpy changes(axis(chart, Qt::Horizontal), &QValueAxis::rangeChanged);
  for (int i = 0; i <= 600; ++i) {
    ledger.append({i / 60.0, {1, 2, 0, 0, 0, 0, 0}});
    chart.setRuns({{&ledger, "RK4"}});
  }
  QCOMPARE(axis(chart, Qt::Horizontal)->max(), 10.0);
  QVERIFY2(changes.size() <= 16, qPrintable(QString::number(changes.size())));
}

void EnergyChartTest::catchesUpWithTheLatestSample() {
  Ledger ledger = sample_ledgers::swinging(1, 101);
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});
  // The last of many calls in a row is drawn too, though not each.
  for (int i = 1; i <= 5; ++i) {
    ledger.append({1 + i / 60.0, {1, 2, 0, 0, 0, 0, 0}});
    chart.refresh();
  }
  QTRY_COMPARE(curveNamed(chart, "Total, RK4")->points().constLast(), QPointF(1 + 5 / 60.0, 3));
}

void EnergyChartTest::leavesCurvesAloneWhenNothingChanged() {
  const Ledger ledger = sample_ledgers::swinging(1, 101);
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});
  QSignalSpy replaced(curveNamed(chart, "Total, RK4"), &QLineSeries::pointsReplaced);
  for (int i = 0; i < 10; ++i) chart.refresh();
  QVERIFY(!replaced.wait(60));  // longer than a refresh may be put off
}

void EnergyChartTest::drawsWhatItMissedWhileHidden() {
  Ledger ledger = sample_ledgers::swinging(1, 101);
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});
  chart.hide();
  ledger.append({2, {1, 2, 0, 0, 0, 0, 0}});
  chart.refresh();
  QCOMPARE(curveNamed(chart, "Total, RK4")->points().constLast().x(), 1.0);
  chart.show();
  QCOMPARE(curveNamed(chart, "Total, RK4")->points().constLast().x(), 2.0);
}

void EnergyChartTest::startsAnewWithTheLedger() {
  Ledger ledger = sample_ledgers::swinging(20, 2001);
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});
  ledger.clear();
  ledger.append({0, {1, 2, 0, 0, 0, 0, 0}});
  chart.refresh();
  QTRY_COMPARE(curveNamed(chart, "Total, RK4")->points(), (QList<QPointF>{{0, 3}}));
  QCOMPARE(axis(chart, Qt::Horizontal)->max(), 2.0);
}

void EnergyChartTest::showsRopesOnceTheyLoseEnergy() {
  Ledger ledger = sample_ledgers::swinging(1, 101);
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});
  QVERIFY(!curveNamed(chart, "Lost to ropes, RK4")->isVisible());
  ledger.append({1.1, {1, 1, 0, 0, 1, 0, 0}});
  chart.refresh();
  QTRY_VERIFY(curveNamed(chart, "Lost to ropes, RK4")->isVisible());
  QVERIFY(!curveNamed(chart, "Lost to friction, RK4")->isVisible());
}

void EnergyChartTest::switchesThemeLive() {
  const Ledger ledger = sample_ledgers::swinging(1, 101);
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});
  for (const Theme& theme : {Theme::darkTheme(), Theme::light()}) {
    chart.setTheme(theme);
    QCOMPARE(curveNamed(chart, "Total, RK4")->pen().color(), theme.total);
    QCOMPARE(axis(chart, Qt::Vertical)->labelsColor(), theme.faintText);
    QCOMPARE(cornerOf(chart), theme.background);
  }
}

void EnergyChartTest::followsThePalette() {
  ShownChart chart;
  QPalette dark;
  dark.setColor(QPalette::Window, Qt::black);
  dark.setColor(QPalette::WindowText, Qt::white);
  chart.setPalette(dark);
  QCOMPARE(cornerOf(chart), Theme::darkTheme().background);
}

void EnergyChartTest::followsTheLanguage() {
  /// Knows one word.
  class OneWord : public QTranslator {
   public:
    QString translate(const char* context, const char* text, const char*, int) const override {
      const bool known = qstrcmp(context, "ui::EnergyPlot") == 0 && qstrcmp(text, "Time (%1)") == 0;
      return known ? QStringLiteral("Tid (%1)") : QString();
    }
    bool isEmpty() const override { return false; }
  };
  ShownChart chart;
  OneWord translator;
  QCoreApplication::installTranslator(&translator);
  QTRY_COMPARE(axis(chart, Qt::Horizontal)->titleText(), QStringLiteral("Tid (s)"));
}

void EnergyChartTest::drawsNothingYet_data() {
  QTest::addColumn<int>("samples");
  QTest::newRow("no run") << -1;
  QTest::newRow("empty ledger") << 0;
  QTest::newRow("one sample") << 1;
}

void EnergyChartTest::drawsNothingYet() {
  QFETCH(int, samples);
  Ledger ledger;
  if (samples > 0) ledger.append({0, {0, 2.9, 0, 0, 0, 0, 0}});
  ShownChart chart;
  if (samples >= 0) chart.setRuns({{&ledger, "RK4"}});
  chart.refresh();
  QVERIFY(!chart.grab().isNull());
  QCOMPARE(axis(chart, Qt::Horizontal)->max(), 2.0);
  QVERIFY(axis(chart, Qt::Vertical)->max() >= 1);
}

void EnergyChartTest::survivesADivergedRun() {
  const Ledger steady = sample_ledgers::swinging(4, 401);
  const Ledger diverging = sample_ledgers::diverging();
  ShownChart chart;
  chart.setRuns({{&steady, "RK4"}, {&diverging, "Euler"}});

  QCOMPARE(axis(chart, Qt::Vertical)->max(), 30.0);
  QCOMPARE(highestOf(*curveNamed(chart, "Total, Euler")), 30.0);
  QCOMPARE(curveNamed(chart, "Potential, Euler")->points().constLast(), QPointF(1020, 1));
  QVERIFY(!chart.grab().isNull());
}

void EnergyChartTest::fillsItsWindowAtAnySize() {
  const Ledger ledger = sample_ledgers::swinging(4, 401);
  ShownChart chart(QSize(360, 260));
  chart.setRuns({{&ledger, "RK4"}, {&ledger, "Euler"}});
  for (const QSize size : {QSize(1280, 300), QSize(360, 260), QSize(640, 400)}) {
    chart.resize(size);
    chart.grab();
    QCOMPARE(chart.chart()->size().toSize(), size);
    const QRectF plot = chart.chart()->plotArea();
    QVERIFY(plot.width() > 200 && plot.height() > 40);
    QVERIFY(QRectF(QPointF(0, 0), size).contains(plot));
  }
}

void EnergyChartTest::leavesNothingBehind() {
  const Ledger ledger = sample_ledgers::swinging(1, 101);
  for (int i = 0; i < 20; ++i) {
    QPointer<QChart> charts;
    QPointer<QObject> curve;
    QPointer<QObject> valueAxis;
    {
      ShownChart chart;
      chart.setRuns({{&ledger, "RK4"}});
      curve = chart.chart()->series().constFirst();
      chart.setRuns({{&ledger, "RK4"}, {&ledger, "Euler"}});
      QVERIFY(curve.isNull());  // the curves of the runs before
      curve = chart.chart()->series().constFirst();
      charts = chart.chart();
      valueAxis = chart.chart()->axes().constFirst();
    }
    QVERIFY(charts.isNull() && curve.isNull() && valueAxis.isNull());
  }
}

QTEST_MAIN(EnergyChartTest)
#include "energy_chart_test.moc"
