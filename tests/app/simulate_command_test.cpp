#include <QtTest>

#include "tests/app/thrown_scene.h"
#include "tests/support/called_program.h"
#include "tests/support/csv_table.h"
#include "tests/support/file_content.h"
#include "ui/files/scene_file.h"

using tests::contentOf;
using tests::CsvTable;
using tests::csvTableIn;
using tests::Outcome;

namespace {

// Cut at once: phases and the event at the start can be seen.
const QByteArray kHanging = R"({"format": "angry-cuts/scene", "version": 1, "cutTime": 0.25,
    "weights": [{"rope": {"pivot": [2, 2.5], "angle": 30}}, {"position": [3.5, 1]}]})";

// In air this thick Euler's method at a large step is soon beyond all numbers.
const QByteArray kExploding = R"({"format": "angry-cuts/scene", "version": 1,
    "airDensity": 2000, "room": {"width": 1e5, "height": 1e5},
    "weights": [{"mass": 1e-6, "radius": 1, "dragCoefficient": 10, "position": [5e4, 5e4],
                 "velocity": [1e5, 0]}]})";

// Explicit Euler's speed grows at steps above 2 / (q v) = 1/15 s here.
const QByteArray kThickAir = R"({"format": "angry-cuts/scene", "version": 1,
    "gravity": 0, "airDensity": 1000, "room": {"width": 1e5, "height": 1e5},
    "weights": [{"mass": 1, "radius": 0.1, "dragCoefficient": 0.0637, "position": [5e4, 5e4],
                 "velocity": [30, 0]}]})";

}  // namespace

/// `angrycuts simulate`, called as a user calls it.
class SimulateCommandTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void trajectoryHasTheColumnsPromised();
  void energyHasTheColumnsPromised();
  void eventsHaveTheColumnsPromised();
  void listsNoEventBeyondTheEnd();
  void emptiesTheRopesColumnsOnceCut();
  void rowsStandAtMultiplesOfTheSample_data();
  void rowsStandAtMultiplesOfTheSample();
  void samplingNeverChangesTheRun();
  void cutOptionOverridesTheScene();
  void methodAndStepDecideTheRun();
  void writesNumbersTheSameInEveryLocale();
  void standardOutputTakesOneTable();
  void printsAShortTableWhereNoFileIsWanted();
  void writesTheEnergyChart_data();
  void writesTheEnergyChart();
  void simulatesBuiltInScenesByName();
  void divergesWithTheRowsUntilThen();
  void suggestsAStepThatWorks();

 private:
  QByteArray rowsOf(const QStringList& arguments) const;

  tests::CalledProgram m_program{ANGRYCUTS_PROGRAM};
  QString m_thrown;
  QString m_hanging;
  QString m_exploding;
};

void SimulateCommandTest::initTestCase() {
  m_thrown = m_program.write("thrown.json", tests::kThrown);
  m_hanging = m_program.write("hanging.json", kHanging);
  m_exploding = m_program.write("exploding.json", kExploding);
}

QByteArray SimulateCommandTest::rowsOf(const QStringList& arguments) const {
  const Outcome outcome = m_program.call(QStringList{"simulate"} + arguments);
  return outcome.status == 0 ? outcome.output : "failed: " + outcome.error;
}

void SimulateCommandTest::trajectoryHasTheColumnsPromised() {
  const CsvTable table =
      csvTableIn(rowsOf({m_thrown, "--until", "0.5", "--sample", "0.25", "--trajectory", "-"}));
  QCOMPARE(table.header, QByteArray("time,weight,phase,x,y,vx,vy,angle,angular_velocity"));
  QCOMPARE(table.rows.size(), 3);
  QCOMPARE(table.rows[0], QByteArray("0,0,flying,1,5.5,1,0,,").split(','));
  QCOMPARE(table.rows[2].size(), 9);
  // Exact but for the rounding of 30 steps.
  QVERIFY(std::abs(table.rows[2][3].toDouble() - 1.5) < 1e-13);
  QVERIFY(std::abs(table.rows[2][4].toDouble() - 4.25) < 1e-13);
  QVERIFY(std::abs(table.rows[2][6].toDouble() + 5) < 1e-13);
}

void SimulateCommandTest::energyHasTheColumnsPromised() {
  const CsvTable table =
      csvTableIn(rowsOf({m_thrown, "--until", "0.5", "--sample", "0.5", "--energy", "-"}));
  QCOMPARE(table.header, QByteArray("time,kinetic,potential,lost_to_air,lost_to_impacts,"
                                    "lost_to_ropes,lost_to_friction,numerical_drift"));
  QCOMPARE(table.rows.size(), 2);
  QCOMPARE(table.rows[0], QByteArray("0,1,110,0,0,0,0,0").split(','));
  QVERIFY(std::abs(table.rows[1][1].toDouble() - 26) < 1e-11);
  QVERIFY(std::abs(table.rows[1][2].toDouble() - 85) < 1e-11);
}

void SimulateCommandTest::eventsHaveTheColumnsPromised() {
  const CsvTable table = csvTableIn(rowsOf({m_thrown, "--until", "1.2", "--events", "-"}));
  QCOMPARE(table.header, QByteArray("time,event,weight,other,x,y,energy_lost"));
  QCOMPARE(table.rows.size(), 1);
  const QByteArrayList& impact = table.rows.front();
  QVERIFY(std::abs(impact[0].toDouble() - 1) < 1e-12);  // falls 5 m at 10 m/s²
  QCOMPARE(impact.mid(1, 3), (QByteArrayList{"impact-floor", "0", ""}));
  QVERIFY(std::abs(impact[4].toDouble() - 2) < 1e-12);
  QVERIFY(std::abs(impact[5].toDouble() - 0.5) < 1e-12);
  QVERIFY(std::abs(impact[6].toDouble() - 75) < 1e-9);  // ½ · 2 kg · (10² − 5²) m²/s²
}

void SimulateCommandTest::listsNoEventBeyondTheEnd() {
  // The weight hits the floor at 1 s, inside the step that reaches the end.
  QCOMPARE(csvTableIn(rowsOf({m_thrown, "--step", "0.3", "--until", "0.95", "--events", "-"})).rows,
           QList<QByteArrayList>());
}

void SimulateCommandTest::emptiesTheRopesColumnsOnceCut() {
  const CsvTable table =
      csvTableIn(rowsOf({m_hanging, "--until", "0.5", "--sample", "0.25", "--trajectory", "-"}));
  QCOMPARE(table.column(1), (QByteArrayList{"0", "1", "0", "1", "0", "1"}));
  QCOMPARE(table.column(2).mid(0, 3), (QByteArrayList{"tethered", "flying", "flying"}));
  QCOMPARE(table.rows[0].mid(7), (QByteArrayList{"30", "0"}));
  QCOMPARE(table.rows[2].mid(7), (QByteArrayList{"", ""}));

  const CsvTable events = csvTableIn(rowsOf({m_hanging, "--until", "0.25", "--events", "-"}));
  QCOMPARE(events.rows, (QList<QByteArrayList>{{"0.25", "cut", "", "", "", "", "0"}}));

  const QStringList atTheStart{m_hanging, "--cut", "0", "--until", "0", "--events", "-"};
  QCOMPARE(csvTableIn(rowsOf(atTheStart)).rows,
           (QList<QByteArrayList>{{"0", "cut", "", "", "", "", "0"}}));
}

void SimulateCommandTest::rowsStandAtMultiplesOfTheSample_data() {
  QTest::addColumn<QString>("until");
  QTest::addColumn<QString>("sample");
  QTest::addColumn<QByteArrayList>("times");
  const auto row = [](const char* name, const char* until, const char* sample,
                      const QByteArray& times) {
    QTest::newRow(name) << QString(until) << QString(sample) << times.split(' ');
  };
  row("end is a multiple", "0.3", "0.1", "0 0.1 0.2 0.3");
  row("end is none", "0.35", "0.1", "0 0.1 0.2 0.30000000000000004");
  row("only the start", "0", "0.1", "0");
  row("sample beyond the end", "0.5", "1", "0");
  row("finer than the step", "0.01", "0.005", "0 0.005 0.01");
  row("exponent", "1", "5e-1", "0 0.5 1");
}

void SimulateCommandTest::rowsStandAtMultiplesOfTheSample() {
  QFETCH(QString, until);
  QFETCH(QString, sample);
  QFETCH(QByteArrayList, times);
  const CsvTable table =
      csvTableIn(rowsOf({m_thrown, "--until", until, "--sample", sample, "--energy", "-"}));
  QCOMPARE(table.column(0), times);
}

void SimulateCommandTest::samplingNeverChangesTheRun() {
  const auto rows = [this](const char* sample) {
    return csvTableIn(
               rowsOf({"seven-weights", "--until", "4", "--sample", sample, "--trajectory", "-"}))
        .rows;
  };
  const QList<QByteArrayList> coarse = rows("0.5");
  QList<QByteArrayList> fine = rows("0.0078125");  // exactly 1/64 of it
  fine.removeIf([](const QByteArrayList& row) {
    const double time = row[0].toDouble();
    return time * 2 != std::floor(time * 2);
  });
  QCOMPARE(fine, coarse);

  const auto events = [this](const char* sample) {
    return rowsOf({"seven-weights", "--until", "4", "--sample", sample, "--events", "-"});
  };
  QCOMPARE(events("0.01"), events("3"));
}

void SimulateCommandTest::cutOptionOverridesTheScene() {
  const auto phaseAtEnd = [this](const char* cut) {
    const CsvTable table = csvTableIn(rowsOf(
        {m_hanging, "--until", "0.5", "--sample", "0.5", "--cut", cut, "--trajectory", "-"}));
    return table.rows[2][2];
  };
  QCOMPARE(phaseAtEnd("never"), QByteArray("tethered"));
  QCOMPARE(phaseAtEnd("0.4"), QByteArray("flying"));
  QCOMPARE(phaseAtEnd("0"), QByteArray("flying"));
  QCOMPARE(phaseAtEnd("0.6"), QByteArray("tethered"));
}

void SimulateCommandTest::methodAndStepDecideTheRun() {
  const auto heightAtEnd = [this](const char* method, const char* step) {
    const CsvTable table =
        csvTableIn(rowsOf({m_thrown, "--until", "0.5", "--sample", "0.5", "--method", method,
                           "--step", step, "--trajectory", "-"}));
    return table.rows[1][4].toDouble();
  };
  // Euler's parabola lies g h t / 2 above the true one.
  QVERIFY(std::abs(heightAtEnd("euler", "0.1") - (4.25 + 0.25)) < 1e-12);
  QVERIFY(std::abs(heightAtEnd("euler", "0.05") - (4.25 + 0.125)) < 1e-12);
  QVERIFY(std::abs(heightAtEnd("rk4", "0.1") - 4.25) < 1e-12);
}

void SimulateCommandTest::writesNumbersTheSameInEveryLocale() {
  const QStringList call{"simulate", m_thrown, "--until", "0.5", "--trajectory", "-"};
  QCOMPARE(m_program.call(call, {{"LC_ALL", "de_DE.UTF-8"}, {"LANG", "de_DE.UTF-8"}}).output,
           m_program.call(call).output);
}

void SimulateCommandTest::standardOutputTakesOneTable() {
  const Outcome outcome = m_program.call({"simulate", m_thrown, "--until", "1", "--energy", "-",
                                          "--trajectory", m_program.path("trajectory.csv")});
  QCOMPARE(outcome.status, 0);
  QCOMPARE(csvTableIn(outcome.output).rows.size(), 11);
  QCOMPARE(csvTableIn(contentOf(m_program.path("trajectory.csv"))).rows.size(), 11);
}

void SimulateCommandTest::printsAShortTableWhereNoFileIsWanted() {
  const Outcome outcome = m_program.call({"simulate", m_thrown});
  QCOMPARE(outcome.status, 0);
  QCOMPARE(outcome.error, QByteArray());
  QVERIFY(outcome.output.contains("kinetic"));
  QCOMPARE(outcome.output.count('\n'), 2 + 11);  // what it is, columns, rows
}

void SimulateCommandTest::writesTheEnergyChart_data() {
  QTest::addColumn<QString>("ending");
  QTest::addColumn<QByteArray>("start");
  QTest::newRow("png") << "png" << QByteArray("\x89PNG");
  QTest::newRow("svg") << "svg" << QByteArray("<?xml");
  QTest::newRow("pdf") << "PDF" << QByteArray("%PDF");
}

void SimulateCommandTest::writesTheEnergyChart() {
  QFETCH(QString, ending);
  QFETCH(QByteArray, start);
  const QString file = m_program.path("chart." + ending);
  const Outcome outcome = m_program.call({"simulate", m_hanging, "--until", "2", "--chart", file});
  QCOMPARE(outcome.status, 0);
  QCOMPARE(outcome.output + outcome.error, QByteArray());
  QVERIFY(contentOf(file).startsWith(start));
}

void SimulateCommandTest::simulatesBuiltInScenesByName() {
  for (const QString& name : ui::builtInScenes()) {
    const CsvTable table = csvTableIn(rowsOf({name, "--until", "0", "--trajectory", "-"}));
    QCOMPARE(static_cast<std::size_t>(table.rows.size()), ui::builtInScene(name).weights.size());
  }
}

void SimulateCommandTest::divergesWithTheRowsUntilThen() {
  const Outcome outcome = m_program.call({"simulate", m_exploding, "--method", "euler", "--step",
                                          "0.1", "--sample", "0.1", "--energy", "-"});
  QCOMPARE(outcome.status, 3);
  QVERIFY2(QRegularExpression("\\Aangrycuts: diverged at [0-9.]+ s: .*step.*\n\\z")
               .match(outcome.error)
               .hasMatch(),
           outcome.error);
  const CsvTable table = csvTableIn(outcome.output);
  QVERIFY(!table.rows.isEmpty());
  for (const QByteArrayList& row : table.rows) {
    for (const QByteArray& field : row) {
      bool isNumber = false;
      QVERIFY(std::isfinite(field.toDouble(&isNumber)));
      QVERIFY(isNumber);
    }
  }
}

void SimulateCommandTest::suggestsAStepThatWorks() {
  const QStringList call{"simulate", m_program.write("thick-air.json", kThickAir),
                         "--method", "euler",
                         "--until",  "100",
                         "--step"};
  const Outcome diverged = m_program.call(call + QStringList{"0.5"});
  QCOMPARE(diverged.status, 3);
  const auto line = QRegularExpression(
                        "\\Aangrycuts: diverged at ([0-9.]+) s: .*; --step "
                        "([0-9.]+) works\n\\z")
                        .match(diverged.error);
  QVERIFY2(line.hasMatch(), diverged.error);
  QVERIFY(line.captured(1).toDouble() < 100);
  QVERIFY(line.captured(2).toDouble() <= 1.0 / 15);
  QVERIFY(line.captured(2).toDouble() > 0.06);
  QCOMPARE(m_program.call(call + QStringList{line.captured(2)}).status, 0);
}

QTEST_GUILESS_MAIN(SimulateCommandTest)
#include "simulate_command_test.moc"
