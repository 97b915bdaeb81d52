#include "ui/chart/chart_widget.h"

#include <algorithm>

#include <QPointer>
#include <QTest>
#include <QTranslator>

#include "tests/ui/chart/sample_ledgers.h"
#include "tests/ui/chart/shown_chart.h"

using core::Ledger;
using shown_chart::curveNamed;
using shown_chart::pointsOf;
using shown_chart::ShownChart;
using ui::ChartWidget;
using ui::DrawnCurve;
using ui::Theme;

namespace {

constexpr int kLongerThanARefreshMayWait = 60;  // [ms]

double highestOf(const QPolygonF& points) {
  double highest = 0;
  for (const QPointF& point : points) highest = std::max(highest, point.y());
  return highest;
}

QColor cornerOf(ChartWidget& chart) {
  return chart.grab().toImage().pixelColor(2, 2);
}

void setTheme(ChartWidget& chart, bool dark) {
  QPalette palette;
  palette.setColor(QPalette::Window, dark ? Qt::black : Qt::white);
  palette.setColor(QPalette::WindowText, dark ? Qt::white : Qt::black);
  chart.setPalette(palette);
}

}  // namespace

class ChartWidgetTest : public QObject {
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
  void followsTheLanguage();
  void drawsNothingYet_data();
  void drawsNothingYet();
  void survivesADivergedRun();
  void fillsItsWindowAtAnySize();
  void leavesNothingBehind();
};

void ChartWidgetTest::curvesAreTheLedgers() {
  Ledger ledger;
  ledger.append({0, {3, 2, 0, 0, 0, 0, 0}});
  ledger.append({1, {1, 2, 0.5, 0.25, 0.125, 0.0625, -1.0625}});
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});

  using Points = QPolygonF;
  QCOMPARE(pointsOf(chart, "Kinetic", 0), Points({{0, 3}, {1, 1}}));
  QCOMPARE(pointsOf(chart, "Potential", 0), Points({{0, 2}, {1, 2}}));
  QCOMPARE(pointsOf(chart, "Lost to air", 0), Points({{0, 0}, {1, 0.5}}));
  QCOMPARE(pointsOf(chart, "Lost to impacts", 0), Points({{0, 0}, {1, 0.25}}));
  QCOMPARE(pointsOf(chart, "Lost to ropes", 0), Points({{0, 0}, {1, 0.125}}));
  QCOMPARE(pointsOf(chart, "Lost to friction", 0), Points({{0, 0}, {1, 0.0625}}));
  QCOMPARE(pointsOf(chart, "Total", 0), Points({{0, 5}, {1, 3.9375}}));
}

void ChartWidgetTest::drawsTheRunsByLineStyleAndTheQuantitiesByColor() {
  const Ledger ledger = sample_ledgers::swinging(2, 201);
  ShownChart chart;
  setTheme(chart, false);
  chart.setRuns({{&ledger, "RK4"}, {&ledger, "Euler"}});

  const QPen first = curveNamed(chart, "Kinetic", 0)->pen;
  const QPen second = curveNamed(chart, "Kinetic", 1)->pen;
  QCOMPARE(first.style(), Qt::SolidLine);
  QCOMPARE(second.style(), Qt::CustomDashLine);
  QCOMPARE(first.color(), Theme::light().kinetic);
  QCOMPARE(second.color(), Theme::light().kinetic);
}

void ChartWidgetTest::keepsPeaksWithAFewPoints() {
  Ledger ledger = sample_ledgers::swinging(10, 30000);
  core::Energies peak;
  peak.kinetic = 7;
  ledger.append({10.0001, peak});
  ledger.append({10.0002, core::Energies()});
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});

  for (const char* name : {"Kinetic", "Potential", "Total"}) {
    QVERIFY(pointsOf(chart, name).size() <= 2000);
    QVERIFY(pointsOf(chart, name).size() > 600);
  }
  QCOMPARE(highestOf(pointsOf(chart, "Kinetic")), 7.0);
}

void ChartWidgetTest::staysSmallAfterAnHour() {
  const Ledger first = sample_ledgers::swinging(3600, 3600 * 60);
  const Ledger second = sample_ledgers::swinging(3600, 3600 * 60, 1, 1e-4);
  ShownChart chart;
  chart.setRuns({{&first, "RK4"}, {&second, "Euler"}});

  qsizetype points = 0;
  for (const DrawnCurve& curve : chart.plot().drawn()) {
    for (const QPolygonF& line : curve.lines) points += line.size();
  }
  QVERIFY(points <= 10000);
  // Dashes along thousands of swings would take most of the time.
  QCOMPARE(curveNamed(chart, "Kinetic", 1)->pen.style(), Qt::SolidLine);
  QCOMPARE(curveNamed(chart, "Total", 1)->pen.style(), Qt::CustomDashLine);
  QCOMPARE(chart.shown().right(), 4000.0);
}

void ChartWidgetTest::putsBothRunsOnOneScale() {
  const Ledger steady = sample_ledgers::swinging(4, 401);
  const Ledger gaining = sample_ledgers::swinging(4, 401, 1, 2);  // to 11 J
  ShownChart chart;
  chart.setRuns({{&steady, "RK4"}, {&gaining, "Euler"}});

  QVERIFY(chart.shown().bottom() >= 11);
  QVERIFY(chart.shown().bottom() < 20);
  QCOMPARE(pointsOf(chart, "Total", 1).constLast(), QPointF(4, 11));
  QCOMPARE(pointsOf(chart, "Total", 0).constLast(), QPointF(4, 3));
}

void ChartWidgetTest::growsWithTheRun() {
  Ledger ledger;
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});
  int changes = 0;
  for (int i = 0; i <= 600; ++i) {
    ledger.append({i / 60.0, {1, 2, 0, 0, 0, 0, 0}});
    const double before = chart.shown().right();
    chart.setSubject(ui::energyChartKind(), {{{&ledger, "RK4"}}, nullptr, {}});
    if (chart.shown().right() != before) ++changes;
  }
  QCOMPARE(chart.shown().right(), 10.0);
  QVERIFY2(changes <= 16, qPrintable(QString::number(changes)));
}

void ChartWidgetTest::catchesUpWithTheLatestSample() {
  Ledger ledger = sample_ledgers::swinging(1, 101);
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});
  // The last of many calls in a row is drawn too, though not each.
  for (int i = 1; i <= 5; ++i) {
    ledger.append({1 + i / 60.0, {1, 2, 0, 0, 0, 0, 0}});
    chart.refresh();
  }
  QTRY_COMPARE(pointsOf(chart, "Total", 0).constLast(), QPointF(1 + 5 / 60.0, 3));
}

void ChartWidgetTest::leavesCurvesAloneWhenNothingChanged() {
  const Ledger ledger = sample_ledgers::swinging(1, 101);
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});
  const DrawnCurve* before = chart.plot().drawn().data();
  for (int i = 0; i < 10; ++i) chart.refresh();
  QTest::qWait(kLongerThanARefreshMayWait);
  QCOMPARE(chart.plot().drawn().data(), before);  // drawn anew they would lie elsewhere
}

void ChartWidgetTest::drawsWhatItMissedWhileHidden() {
  Ledger ledger = sample_ledgers::swinging(1, 101);
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});
  chart.hide();
  ledger.append({2, {1, 2, 0, 0, 0, 0, 0}});
  chart.refresh();
  QCOMPARE(pointsOf(chart, "Total", 0).constLast().x(), 1.0);
  chart.show();
  QCOMPARE(pointsOf(chart, "Total", 0).constLast().x(), 2.0);
}

void ChartWidgetTest::startsAnewWithTheLedger() {
  Ledger ledger = sample_ledgers::swinging(20, 2001);
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});
  ledger.clear();
  ledger.append({0, {1, 2, 0, 0, 0, 0, 0}});
  chart.refresh();
  QTRY_COMPARE(pointsOf(chart, "Total", 0), QPolygonF({{0, 3}}));
  QCOMPARE(chart.shown().right(), 2.0);
}

void ChartWidgetTest::showsRopesOnceTheyLoseEnergy() {
  Ledger ledger = sample_ledgers::swinging(1, 101);
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});
  QVERIFY(curveNamed(chart, "Lost to ropes") == nullptr);
  ledger.append({1.1, {1, 1, 0, 0, 1, 0, 0}});
  chart.refresh();
  QTRY_VERIFY(curveNamed(chart, "Lost to ropes") != nullptr);
  QVERIFY(curveNamed(chart, "Lost to friction") == nullptr);
}

void ChartWidgetTest::switchesThemeLive() {
  const Ledger ledger = sample_ledgers::swinging(1, 101);
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});
  for (const Theme& theme : {Theme::darkTheme(), Theme::light()}) {
    setTheme(chart, theme.dark);
    QCOMPARE(curveNamed(chart, "Total")->pen.color(), theme.total);
    QCOMPARE(cornerOf(chart), theme.background);
  }
}

void ChartWidgetTest::followsTheLanguage() {
  /// Knows one word.
  class OneWord : public QTranslator {
   public:
    QString translate(const char* context, const char* text, const char*, int) const override {
      const bool known = qstrcmp(context, "ui::EnergyChart") == 0 && qstrcmp(text, "Time") == 0;
      return known ? QStringLiteral("Tid") : QString();
    }
    bool isEmpty() const override { return false; }
  };
  const Ledger ledger = sample_ledgers::swinging(1, 101);
  ShownChart chart;
  chart.setRuns({{&ledger, "RK4"}});
  OneWord translator;
  QCoreApplication::installTranslator(&translator);
  QTRY_COMPARE(chart.plot().content().horizontal.quantity, QStringLiteral("Tid"));
}

void ChartWidgetTest::drawsNothingYet_data() {
  QTest::addColumn<int>("samples");
  QTest::newRow("no run") << -1;
  QTest::newRow("empty ledger") << 0;
  QTest::newRow("one sample") << 1;
}

void ChartWidgetTest::drawsNothingYet() {
  QFETCH(int, samples);
  Ledger ledger;
  if (samples > 0) ledger.append({0, {0, 2.9, 0, 0, 0, 0, 0}});
  ShownChart chart;
  if (samples >= 0) chart.setRuns({{&ledger, "RK4"}});
  chart.refresh();
  QVERIFY(!chart.grab().isNull());
  QCOMPARE(chart.shown().right(), 2.0);
  QVERIFY(chart.shown().bottom() >= 1);
}

void ChartWidgetTest::survivesADivergedRun() {
  const Ledger steady = sample_ledgers::swinging(4, 401);
  const Ledger diverging = sample_ledgers::diverging();
  ShownChart chart;
  chart.setRuns({{&steady, "RK4"}, {&diverging, "Euler"}});

  QCOMPARE(chart.shown().bottom(), 30.0);
  QCOMPARE(highestOf(pointsOf(chart, "Total", 1)), 30.0);
  QCOMPARE(pointsOf(chart, "Potential", 1).constLast(), QPointF(1020, 1));
  QVERIFY(!chart.grab().isNull());
}

void ChartWidgetTest::fillsItsWindowAtAnySize() {
  const Ledger ledger = sample_ledgers::swinging(4, 401);
  ShownChart chart(QSize(360, 260));
  chart.setRuns({{&ledger, "RK4"}, {&ledger, "Euler"}});
  for (const QSize size : {QSize(1280, 300), QSize(360, 260), QSize(900, 200), QSize(640, 400)}) {
    chart.resize(size);
    chart.grab();
    const QRectF plot = chart.plotArea();
    QVERIFY(plot.width() > 200 && plot.height() > 40);
    QVERIFY(QRectF(QPointF(0, 0), size).contains(plot));
  }
}

void ChartWidgetTest::leavesNothingBehind() {
  const Ledger ledger = sample_ledgers::swinging(1, 101);
  for (int i = 0; i < 20; ++i) {
    QPointer<const ui::ChartPlot> plot;
    {
      ShownChart chart;
      chart.setRuns({{&ledger, "RK4"}});
      plot = &chart.plot();
    }
    QVERIFY(plot.isNull());
  }
}

QTEST_MAIN(ChartWidgetTest)
#include "chart_widget_test.moc"
