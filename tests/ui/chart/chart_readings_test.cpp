#include "ui/chart/chart_readings.h"

#include <cmath>

#include <QChart>
#include <QTest>

#include "tests/ui/chart/recorded_scene.h"
#include "tests/ui/chart/sample_ledgers.h"
#include "ui/chart/chart_plot.h"

using ui::ChartReading;

namespace {

const ui::ChartKind& kindNamed(const char* id) {
  return *std::ranges::find_if(ui::chartKinds(),
                               [id](const auto& kind) { return qstrcmp(kind.id, id) == 0; });
}

/// A chart that is not on any screen.
struct Plotted {
  QChart chart;
  ui::ChartPlot* plot = new ui::ChartPlot(&chart);

  Plotted(const char* kind, ui::ChartSubject subject) {
    chart.resize(640, 400);
    plot->setLook(ui::ChartLook::forPaper());
    plot->setSubject(kindNamed(kind), std::move(subject));
  }
};

}  // namespace

class ChartReadingsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void readsEachCurveBetweenItsSamples();
  void readsNothingOutsideTheRun();
  void leavesOutWhatIsHidden();
  void readsAnglesAndRatesOfAPhasePortrait();
  void readsTheAmountsOfAStack();
  void findsTheMomentOfTheNearestPlace();
};

void ChartReadingsTest::readsEachCurveBetweenItsSamples() {
  core::Ledger ledger;
  ledger.append({0, {3, 2, 0, 0, 0, 0, 0}});
  ledger.append({1, {1, 2, 0.5, 0.25, 0, 0, -1.25}});
  const Plotted plotted("energy", {{{&ledger, "RK4"}}, nullptr, {}});
  const auto readings = ui::readingsAt(*plotted.plot, 0.25);
  QStringList texts;
  for (const ChartReading& reading : readings) texts << reading.name + ' ' + reading.text;
  QCOMPARE(texts,
           QStringList({"Kinetic 2.50\u00a0J", "Potential 2.00\u00a0J", "Lost to air 0.125\u00a0J",
                        "Lost to impacts 0.0625\u00a0J", "Total 4.69\u00a0J"}));
  QCOMPARE(readings[0].place, QPointF(0.25, 2.5));
}

void ChartReadingsTest::readsNothingOutsideTheRun() {
  const core::Ledger ledger = sample_ledgers::swinging(2, 201);
  const Plotted plotted("energy", {{{&ledger, "RK4"}}, nullptr, {}});
  QVERIFY(ui::readingsAt(*plotted.plot, 2.01).empty());
  QVERIFY(ui::readingsAt(*plotted.plot, -0.01).empty());
  QVERIFY(!ui::readingsAt(*plotted.plot, 2).empty());
}

void ChartReadingsTest::leavesOutWhatIsHidden() {
  const core::Ledger ledger = sample_ledgers::swinging(2, 201);
  const Plotted plotted("energy", {{{&ledger, "RK4"}, {&ledger, "Euler"}}, nullptr, {}});
  plotted.plot->setHidden({{"Kinetic"}, {1}});
  for (const ChartReading& reading : ui::readingsAt(*plotted.plot, 1)) {
    QVERIFY(reading.name != "Kinetic");
    QCOMPARE(reading.run, std::size_t{0});
  }
}

void ChartReadingsTest::readsAnglesAndRatesOfAPhasePortrait() {
  RecordedScene scene(1, 0.4, {{.method = "rk4"}});
  scene.runUntil(1);
  const Plotted plotted("phase", scene.subject({0}));
  QCOMPARE(ui::readingsAt(*plotted.plot, 0)[0].text, QString("60.0°; 0\u00a0°/s"));
  QVERIFY(ui::readingsAt(*plotted.plot, 0.5).empty());  // cut
}

void ChartReadingsTest::readsTheAmountsOfAStack() {
  core::Ledger ledger;
  ledger.append({0, {3, 2, 0, 0, 0, 0, 0}});
  ledger.append({1, {1, 2, 0.5, 0.25, 0, 0, -1.25}});
  const Plotted plotted("ledger", {{{&ledger, "RK4"}}, nullptr, {}});
  for (const ChartReading& reading : ui::readingsAt(*plotted.plot, 1)) {
    if (reading.name == "Kinetic") QCOMPARE(reading.text, QString("1.00\u00a0J"));
    if (reading.name == "Kinetic") QCOMPARE(reading.place.y(), 3.0);
    if (reading.name == "Numerical drift") QCOMPARE(reading.text, QString("−1.25\u00a0J"));
    if (reading.name == "At the start") QCOMPARE(reading.text, QString("5.00\u00a0J"));
  }
}

void ChartReadingsTest::findsTheMomentOfTheNearestPlace() {
  RecordedScene scene(1, 10, {{.method = "rk4"}});
  scene.runUntil(1);
  const Plotted plotted("phase", scene.subject({0}));
  const auto passed = ui::readingsAt(*plotted.plot, 0.5)[0].place;
  const QSizeF unit(4, 2);  // [px]
  const auto found = ui::nearestTime(*plotted.plot, passed + QPointF(0.1, 0), unit, 40);
  QCOMPARE(*found, 0.5);
  QVERIFY(!ui::nearestTime(*plotted.plot, passed + QPointF(1000, 0), unit, 40));
}

QTEST_MAIN(ChartReadingsTest)
#include "chart_readings_test.moc"
