#include "ui/chart/chart_table.h"

#include <QChart>
#include <QTest>

#include "tests/ui/chart/recorded_scene.h"
#include "ui/chart/chart_plot.h"

namespace {

/// A chart that is not on any screen.
struct Plotted {
  QChart chart;
  ui::ChartPlot* plot = new ui::ChartPlot(&chart);

  Plotted(int kind, ui::ChartSubject subject) {
    chart.resize(640, 400);
    plot->setLook(ui::ChartLook::forPaper());
    plot->setSubject(ui::chartKinds()[kind], std::move(subject));
  }
};

constexpr int kEnergy = 0;
constexpr int kPaths = 3;

}  // namespace

class ChartTableTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void init();
  void givesEachRunItsOwnTimes();
  void givesOnlyWhatIsShown();
  void suitsTheReadersSpreadsheet();
  void givesBothCoordinatesOfPaths();
  void readsBackExactly();

 private:
  core::Ledger m_coarse;
  core::Ledger m_fine;
};

void ChartTableTest::init() {
  m_coarse.clear();
  m_fine.clear();
  m_coarse.append({0, {1, 2, 0, 0, 0, 0, 0}});
  m_coarse.append({1, {0.5, 2, 0, 0, 0, 0, -0.5}});
  for (int i = 0; i < 3; ++i) m_fine.append({i / 2.0, {1, 2.25, 0, 0, 0, 0, 0}});
}

void ChartTableTest::givesEachRunItsOwnTimes() {
  const Plotted plotted(kEnergy, {{{&m_coarse, "A"}, {&m_fine, "B"}}, nullptr, {}});
  plotted.plot->setHidden({{"Lost to air", "Lost to impacts", "Total"}, {}});
  QCOMPARE(ui::chartTable(*plotted.plot, '\t', "."),
           QString("Time (s), A\tKinetic (J), A\tPotential (J), A\t"
                   "Time (s), B\tKinetic (J), B\tPotential (J), B\n"
                   "0\t1\t2\t0\t1\t2.25\n"
                   "1\t0.5\t2\t0.5\t1\t2.25\n"
                   "\t\t\t1\t1\t2.25\n"));
}

void ChartTableTest::givesOnlyWhatIsShown() {
  const Plotted plotted(kEnergy, {{{&m_fine, "B"}}, nullptr, {}});
  plotted.plot->setHidden({{"Kinetic", "Lost to air", "Lost to impacts", "Total"}, {}});
  plotted.plot->setZoom(QRectF(0.3, 0, 0.4, 3));
  QCOMPARE(ui::chartTable(*plotted.plot, ';', "."),
           QString("Time (s), B;Potential (J), B\n0.5;2.25\n"));
}

void ChartTableTest::suitsTheReadersSpreadsheet() {
  const Plotted plotted(kEnergy, {{{&m_fine, "1/60, \"B\""}}, nullptr, {}});
  plotted.plot->setHidden({{"Kinetic", "Lost to air", "Lost to impacts", "Total"}, {}});
  plotted.plot->setZoom(QRectF(0.3, 0, 0.4, 3));
  QCOMPARE(
      ui::chartTable(*plotted.plot, '\t', ","),
      QString("\"Time (s), 1/60, \"\"B\"\"\"\t\"Potential (J), 1/60, \"\"B\"\"\"\n0,5\t2,25\n"));
}

void ChartTableTest::givesBothCoordinatesOfPaths() {
  RecordedScene scene(2, 1, {{.method = "rk4"}});
  scene.runUntil(0.5);
  const Plotted plotted(kPaths, scene.subject({1}));
  const QStringList lines = ui::chartTable(*plotted.plot, '\t', ".").split('\n');
  QCOMPARE(lines.first(),
           QString("Time (s), run 1\tWeight 2: x (m), run 1\tWeight 2: y (m), run 1"));
  QCOMPARE(lines.size(), 1 + 31 + 1);
}

void ChartTableTest::readsBackExactly() {
  RecordedScene scene(2, 1, {{.method = "rk4"}});
  scene.runUntil(0.5);
  const Plotted plotted(kPaths, scene.subject({1}));
  const QStringList lines = ui::chartTable(*plotted.plot, '\t', ".").split('\n');
  const core::WeightState now = scene.run(0).weight(1);
  const QStringList last = lines[31].split('\t');
  QCOMPARE(last[0].toDouble(), scene.run(0).time());
  QVERIFY(last[1].toDouble() == now.position.x());
  QVERIFY(last[2].toDouble() == now.position.y());
}

QTEST_MAIN(ChartTableTest)
#include "chart_table_test.moc"
