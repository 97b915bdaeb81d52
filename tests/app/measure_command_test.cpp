#include <cmath>

#include <QtTest>

#include "core/trade/settings.h"
#include "tests/support/called_program.h"

using tests::Outcome;

namespace {

/// Rows of a CSV table without its header, field by field.
QList<QByteArrayList> rowsIn(const QByteArray& csv) {
  QList<QByteArrayList> rows;
  for (const QByteArray& line : csv.split('\n').mid(1)) {
    if (!line.isEmpty()) rows << line.trimmed().split(',');
  }
  return rows;
}

const QByteArray kHeader =
    "method,setting,steps,evaluations,max_position_error,max_energy_drift,"
    "nanoseconds_per_simulated_second,outcome\r\n";

// In air this thick Euler's method at a large step is soon beyond all numbers.
const QByteArray kThickAir = R"({"format": "angry-cuts/scene", "version": 1, "airDensity": 30,
    "room": {"width": 1000}, "weights": [{"mass": 1e-3, "position": [1, 1],
    "velocity": [100, 0]}]})";

}  // namespace

/// `angrycuts measure`, called as a user calls it.
class MeasureCommandTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void writesARowForEachSettingOfEachMethod();
  void printsAShortTableWithOrdersCostsAndASentence();
  void untilAndCutAreTakenAsForSimulate();
  void saysWhatDivergedAndWhen();
  void writesTheChartBesideTheTable();
  void showsProgressOnATerminalOnly();
  void refusesCalls_data();
  void refusesCalls();
  void saysWhenAFileCannotBeWritten();
  void noticesAFullDisk();

 private:
  Outcome run(const QStringList& arguments) const;

  tests::CalledProgram m_program{ANGRYCUTS_PROGRAM};
  QString m_pendulum;
};

void MeasureCommandTest::initTestCase() {
  QFile reference(ANGRYCUTS_REFERENCE_DIR "/pendulum-vacuum-120.json");
  QVERIFY(reference.open(QIODevice::ReadOnly));
  const QJsonObject scene = QJsonDocument::fromJson(reference.readAll())["scene"].toObject();
  m_pendulum = m_program.write("pendulum.json", QJsonDocument(scene).toJson());
}

Outcome MeasureCommandTest::run(const QStringList& arguments) const {
  return m_program.call(QStringList{"measure"} + arguments);
}

void MeasureCommandTest::writesARowForEachSettingOfEachMethod() {
  const Outcome outcome = run({m_pendulum, "--csv", "-"});
  QCOMPARE(outcome.status, 0);
  QCOMPARE(outcome.error, QByteArray());
  QVERIFY(outcome.output.startsWith(kHeader));
  const QList<QByteArrayList> rows = rowsIn(outcome.output);
  const std::vector<core::Solver> solvers = core::measuredSolvers();
  QCOMPARE(rows.size(), static_cast<qsizetype>(solvers.size()));
  for (qsizetype i = 0; i < rows.size(); ++i) {
    QCOMPARE(rows[i].size(), 8);
    QCOMPARE(rows[i][0], QByteArray::fromStdString(solvers[i].method));
    QCOMPARE(rows[i][1].toDouble(), core::settingOf(solvers[i]));
    QVERIFY(rows[i][2].toLongLong() > 0);
    QVERIFY(rows[i][3].toLongLong() >= rows[i][2].toLongLong());
    QVERIFY(rows[i][4].toDouble() > 0);
    QVERIFY(rows[i][6].toDouble() > 0);
    QCOMPARE(rows[i][7], QByteArray("ok"));
  }
  QCOMPARE(rows[0].mid(0, 4), QByteArrayList({"euler", "0.125", "80", "80"}));
}

void MeasureCommandTest::printsAShortTableWithOrdersCostsAndASentence() {
  const Outcome outcome = run({m_pendulum});
  QCOMPARE(outcome.status, 0);
  const QString text = QString::fromUtf8(outcome.output);
  QVERIFY(text.startsWith("Measured over 10 s."));
  for (const core::Method& method : core::methods()) {
    const QString name = QString::fromStdString(std::string(method.name));
    const QRegularExpression row("^" + QRegularExpression::escape(name) +
                                     "\\s+([0-9.]+)\\s+([0-9.e-]+)\\s+([0-9.e-]+)\\s+([0-9.e+]+)",
                                 QRegularExpression::MultilineOption);
    const QRegularExpressionMatch match = row.match(text);
    QVERIFY2(match.hasMatch(), qPrintable(text));
    // A tolerance is no step: only steps have a stated order.
    if (!method.isAdaptive) QVERIFY(std::abs(match.captured(1).toDouble() - method.order) <= 0.1);
    QVERIFY(match.captured(4).toDouble() > 0);
  }
  QVERIFY(text.contains("To be right within 1\u00a0mm over 10 s: "));
}

void MeasureCommandTest::untilAndCutAreTakenAsForSimulate() {
  const auto stepsOf = [this](const QStringList& options) {
    return rowsIn(run(QStringList{"one-pendulum", "--csv", "-"} + options).output)[0];
  };
  QCOMPARE(stepsOf({"--until", "1", "--cut", "never"})[2], QByteArray("8"));
  QCOMPARE(stepsOf({"--until", "1.1"})[2], QByteArray("9"));
  // Without air a cut at once leaves a fall that Euler gets wrong by g t h / 2 at its end.
  const QString hanging =
      m_program.write("fall.json", R"({"format": "angry-cuts/scene", "version": 1,
      "gravity": 10, "airDensity": 0, "room": {"width": 10, "height": 10},
      "weights": [{"rope": {"pivot": [5, 9]}}]})");
  const QByteArrayList row =
      rowsIn(run({hanging, "--csv", "-", "--until", "1", "--cut", "0"}).output)[0];
  QVERIFY2(std::abs(row[4].toDouble() - 10 * 0.125 / 2) < 1e-9, row[4]);
}

void MeasureCommandTest::saysWhatDivergedAndWhen() {
  const Outcome outcome =
      run({m_program.write("thick.json", kThickAir), "--until", "2", "--csv", "-"});
  QCOMPARE(outcome.status, 0);
  const QByteArrayList first = rowsIn(outcome.output)[0];
  static const QRegularExpression kOutcome("^diverged at ([0-9.]+)$");
  const QRegularExpressionMatch match = kOutcome.match(first[7]);
  QVERIFY2(match.hasMatch(), first[7]);
  QVERIFY(match.captured(1).toDouble() < 2);
  QCOMPARE(rowsIn(outcome.output)[10][7], QByteArray("ok"));
}

void MeasureCommandTest::writesTheChartBesideTheTable() {
  const Outcome outcome =
      run({"one-pendulum", "--until", "1", "--csv", "m.csv", "--chart", "m.svg"});
  QCOMPARE(outcome.status, 0);
  QCOMPARE(outcome.output, QByteArray());
  QFile csv(m_program.path("m.csv")), chart(m_program.path("m.svg"));
  QVERIFY(csv.open(QIODevice::ReadOnly) && chart.open(QIODevice::ReadOnly));
  QVERIFY(csv.readAll().startsWith(kHeader));
  QVERIFY(chart.readAll().contains("Computing time per simulated second"));
}

void MeasureCommandTest::showsProgressOnATerminalOnly() {
  QCOMPARE(run({"one-pendulum", "--until", "1"}).error, QByteArray());
  QProcess terminal;
  const QString call = QStringLiteral(ANGRYCUTS_PROGRAM " measure one-pendulum --csv /dev/null");
  terminal.start("script", {"-qec", call, "/dev/null"});
  QVERIFY(terminal.waitForFinished(120'000));
  const QByteArray shown = terminal.readAllStandardOutput();
  QVERIFY2(shown.contains("\rMeasuring: "), shown);
  QVERIFY(shown.endsWith("\r\x1b[K"));  // nothing is left of it
}

void MeasureCommandTest::refusesCalls_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("error");
  const auto row = [](const char* name, const QStringList& arguments, const char* error) {
    QTest::newRow(name) << arguments << "angrycuts: " + QByteArray(error) + '\n';
  };
  row("no scene", {}, "measure: a scene must be named");
  row("unknown scene", {"no-such"}, "no-such: no file or built-in scene of that name");
  row("option of another call", {"one-pendulum", "--step", "1"}, "Unknown option 'step'.");
  row("time", {"one-pendulum", "--until", "-1"}, "--until: must be from 0 to 1000000 s, got -1");
  row("cut", {"one-pendulum", "--cut", "soon"}, "--cut: must be a number, got \"soon\"");
  row("kind of chart", {"one-pendulum", "--chart", "m.gif"},
      "--chart: must end in .png, .svg or .pdf, got \"m.gif\"");
  row("one file for two", {"one-pendulum", "--csv", "m.svg", "--chart", "m.svg"},
      "--chart: m.svg is used twice");
}

void MeasureCommandTest::refusesCalls() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, error);
  const Outcome outcome = run(arguments);
  QCOMPARE(outcome.status, 2);
  QCOMPARE(outcome.output, QByteArray());
  QCOMPARE(outcome.error, error);
}

void MeasureCommandTest::saysWhenAFileCannotBeWritten() {
  for (const char* option : {"--csv", "--chart"}) {
    const Outcome outcome = run({"one-pendulum", "--until", "1", option, "no/such/m.svg"});
    QCOMPARE(outcome.status, 1);
    QVERIFY(outcome.error.startsWith("angrycuts: no/such/m.svg: "));
  }
}

void MeasureCommandTest::noticesAFullDisk() {
  const Outcome outcome = run({"one-pendulum", "--until", "0.1", "--csv", "/dev/full"});
  QCOMPARE(outcome.status, 1);
  QVERIFY(outcome.error.startsWith("angrycuts: /dev/full: "));
}

QTEST_GUILESS_MAIN(MeasureCommandTest)
#include "measure_command_test.moc"
