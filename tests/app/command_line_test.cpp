#include <initializer_list>

#include <QtTest>

#include "ui/files/scene_file.h"

namespace {

/// What a call of the program left behind.
struct Outcome {
  int status = -1;
  QByteArray output;
  QByteArray error;
};

/// A table read from CSV: the first line, and the fields of the others.
struct Table {
  QByteArray header;
  QList<QByteArrayList> rows;

  QByteArrayList column(qsizetype index) const {
    QByteArrayList fields;
    for (const QByteArrayList& row : rows) fields.append(row.value(index));
    return fields;
  }
};

/// Checks that every line ends in CR LF.
Table tableIn(const QByteArray& csv) {
  Table table;
  QByteArrayList lines = csv.split('\n');
  if (lines.takeLast() != "") qFatal("the last line has no end");
  for (QByteArray& line : lines) {
    if (!line.endsWith('\r')) qFatal("a line does not end in CR LF");
    line.chop(1);
  }
  table.header = lines.takeFirst();
  for (const QByteArray& line : lines) table.rows.append(line.split(','));
  return table;
}

QByteArray contentOf(const QString& file) {
  QFile input(file);
  return input.open(QIODevice::ReadOnly) ? input.readAll() : QByteArray("cannot be read");
}

// A weight in flight without air: every step of RK4 is exact but for rounding.
const QByteArray kThrown = R"({"format": "angry-cuts/scene", "version": 1, "gravity": 10,
    "airDensity": 0, "room": {"width": 10, "height": 10, "restitution": 0.5},
    "weights": [{"mass": 2, "radius": 0.5, "position": [1, 5.5], "velocity": [1, 0]}]})";

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

class CommandLineTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();

  void helpNamesEveryCallAndOption();
  void helpNamesEveryMethodAndNoOther();
  void versionIsOneLine();

  void listsScenesWithOneSentenceEach();
  void exportsScenesAsFiles();
  void saysWhatKeepsScenesFromBeingExported();

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

  void refusesCalls_data();
  void refusesCalls();
  void refusesScenesWithTheirPlace();
  void divergesWithTheRowsUntilThen();
  void suggestsAStepThatWorks();
  void saysWhenAFileCannotBeWritten();
  void opensItsFilesBeforeItSimulates();
  void noticesAFullDisk();
  void noticesAClosedPipe();
  void leavesOldFilesWhereItFails();
  void showsWhatItCanWithoutADisplay();

 private:
  Outcome run(const QStringList& arguments, const QMap<QString, QString>& environment = {}) const;
  Outcome runInShell(const QString& command) const;
  QByteArray rowsOf(const QStringList& arguments) const;
  QString path(const QString& name) const { return m_folder.filePath(name); }
  QString write(const QString& name, const QByteArray& content) const;

  QTemporaryDir m_folder;
  QString m_thrown;
  QString m_hanging;
  QString m_exploding;
};

void CommandLineTest::initTestCase() {
  m_thrown = write("thrown.json", kThrown);
  m_hanging = write("hanging.json", kHanging);
  m_exploding = write("exploding.json", kExploding);
}

QString CommandLineTest::write(const QString& name, const QByteArray& content) const {
  QFile file(path(name));
  if (!file.open(QIODevice::WriteOnly)) qFatal("no room for the test's files");
  file.write(content);
  return file.fileName();
}

Outcome CommandLineTest::run(const QStringList& arguments,
                             const QMap<QString, QString>& environment) const {
  QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
  for (auto entry = environment.begin(); entry != environment.end(); ++entry) {
    all.insert(entry.key(), entry.value());
  }
  QProcess process;
  process.setProcessEnvironment(all);
  process.setWorkingDirectory(m_folder.path());
  process.start(ANGRYCUTS_PROGRAM, arguments);
  process.waitForFinished(60'000);
  const bool ended = process.exitStatus() == QProcess::NormalExit;
  return {ended ? process.exitCode() : -1, process.readAllStandardOutput(),
          process.readAllStandardError()};
}

/// @param command  the program is $1, this test's folder the working directory
Outcome CommandLineTest::runInShell(const QString& command) const {
  QProcess process;
  process.setWorkingDirectory(m_folder.path());
  process.start("bash", {"-c", command, "bash", ANGRYCUTS_PROGRAM});
  process.waitForFinished(60'000);
  return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

QByteArray CommandLineTest::rowsOf(const QStringList& arguments) const {
  const Outcome outcome = run(QStringList{"simulate"} + arguments);
  return outcome.status == 0 ? outcome.output : "failed: " + outcome.error;
}

void CommandLineTest::helpNamesEveryCallAndOption() {
  const Outcome outcome = run({"--help"});
  QCOMPARE(outcome.status, 0);
  QCOMPARE(outcome.error, QByteArray());
  for (const char* word :
       {"angrycuts [SCENE]", "scenes", "--export", "simulate", "measure", "--csv", "--method",
        "--step", "--tolerance", "--until", "--cut", "--sample", "--trajectory", "--energy",
        "--events", "--chart", "--version"}) {
    QVERIFY2(outcome.output.contains(word), word);
  }
  QCOMPARE(run({"simulate", "--help"}).output, outcome.output);
}

void CommandLineTest::helpNamesEveryMethodAndNoOther() {
  const QByteArray help = run({"--help"}).output;
  QVERIFY(help.contains("  --method NAME        euler, semi-implicit-euler, rk4, dopri5 (rk4)\n"));
  QVERIFY(!help.contains("reference"));
}

void CommandLineTest::versionIsOneLine() {
  const Outcome outcome = run({"--version"});
  QCOMPARE(outcome.status, 0);
  QVERIFY(
      QRegularExpression("\\Aangrycuts \\d+\\.\\d+\\.\\d+\n\\z").match(outcome.output).hasMatch());
}

void CommandLineTest::listsScenesWithOneSentenceEach() {
  const Outcome outcome = run({"scenes"});
  QCOMPARE(outcome.status, 0);
  QStringList names;
  for (const QByteArray& line : outcome.output.trimmed().split('\n')) {
    const QByteArrayList fields = line.split('\t');
    QCOMPARE(fields.size(), 2);
    names.append(fields[0]);
    QVERIFY(fields[1].endsWith('.'));
  }
  QCOMPARE(names, ui::builtInScenes());
}

void CommandLineTest::exportsScenesAsFiles() {
  const QString folder = path("new/scenes");
  QCOMPARE(run({"scenes", "--export", folder}).status, 0);
  for (const QString& name : ui::builtInScenes()) {
    const ui::SceneOrError read = ui::readSceneFile(folder + '/' + name + ".json");
    QCOMPARE(read.error, QString());
    QCOMPARE(ui::sceneText(*read.scene), ui::sceneText(ui::builtInScene(name)));
  }
}

void CommandLineTest::saysWhatKeepsScenesFromBeingExported() {
  const Outcome outcome = run({"scenes", "--export", m_thrown});
  QCOMPARE(outcome.status, 1);
  QCOMPARE(outcome.error, "angrycuts: " + m_thrown.toUtf8() + ": the folder cannot be made\n");
}

void CommandLineTest::trajectoryHasTheColumnsPromised() {
  const Table table =
      tableIn(rowsOf({m_thrown, "--until", "0.5", "--sample", "0.25", "--trajectory", "-"}));
  QCOMPARE(table.header, QByteArray("time,weight,phase,x,y,vx,vy,angle,angular_velocity"));
  QCOMPARE(table.rows.size(), 3);
  QCOMPARE(table.rows[0], QByteArray("0,0,flying,1,5.5,1,0,,").split(','));
  QCOMPARE(table.rows[2].size(), 9);
  // Exact but for the rounding of 30 steps.
  QVERIFY(std::abs(table.rows[2][3].toDouble() - 1.5) < 1e-13);
  QVERIFY(std::abs(table.rows[2][4].toDouble() - 4.25) < 1e-13);
  QVERIFY(std::abs(table.rows[2][6].toDouble() + 5) < 1e-13);
}

void CommandLineTest::energyHasTheColumnsPromised() {
  const Table table =
      tableIn(rowsOf({m_thrown, "--until", "0.5", "--sample", "0.5", "--energy", "-"}));
  QCOMPARE(table.header, QByteArray("time,kinetic,potential,lost_to_air,lost_to_impacts,"
                                    "lost_to_ropes,lost_to_friction,numerical_drift"));
  QCOMPARE(table.rows.size(), 2);
  QCOMPARE(table.rows[0], QByteArray("0,1,110,0,0,0,0,0").split(','));
  QVERIFY(std::abs(table.rows[1][1].toDouble() - 26) < 1e-11);
  QVERIFY(std::abs(table.rows[1][2].toDouble() - 85) < 1e-11);
}

void CommandLineTest::eventsHaveTheColumnsPromised() {
  const Table table = tableIn(rowsOf({m_thrown, "--until", "1.2", "--events", "-"}));
  QCOMPARE(table.header, QByteArray("time,event,weight,other,x,y,energy_lost"));
  QCOMPARE(table.rows.size(), 1);
  const QByteArrayList& impact = table.rows.front();
  QVERIFY(std::abs(impact[0].toDouble() - 1) < 1e-12);  // falls 5 m at 10 m/s²
  QCOMPARE(impact.mid(1, 3), (QByteArrayList{"impact-floor", "0", ""}));
  QVERIFY(std::abs(impact[4].toDouble() - 2) < 1e-12);
  QVERIFY(std::abs(impact[5].toDouble() - 0.5) < 1e-12);
  QVERIFY(std::abs(impact[6].toDouble() - 75) < 1e-9);  // ½ · 2 kg · (10² − 5²) m²/s²
}

void CommandLineTest::listsNoEventBeyondTheEnd() {
  // The weight hits the floor at 1 s, inside the step that reaches the end.
  QCOMPARE(tableIn(rowsOf({m_thrown, "--step", "0.3", "--until", "0.95", "--events", "-"})).rows,
           QList<QByteArrayList>());
}

void CommandLineTest::emptiesTheRopesColumnsOnceCut() {
  const Table table =
      tableIn(rowsOf({m_hanging, "--until", "0.5", "--sample", "0.25", "--trajectory", "-"}));
  QCOMPARE(table.column(1), (QByteArrayList{"0", "1", "0", "1", "0", "1"}));
  QCOMPARE(table.column(2).mid(0, 3), (QByteArrayList{"tethered", "flying", "flying"}));
  QCOMPARE(table.rows[0].mid(7), (QByteArrayList{"30", "0"}));
  QCOMPARE(table.rows[2].mid(7), (QByteArrayList{"", ""}));

  const Table events = tableIn(rowsOf({m_hanging, "--until", "0.25", "--events", "-"}));
  QCOMPARE(events.rows, (QList<QByteArrayList>{{"0.25", "cut", "", "", "", "", "0"}}));
}

void CommandLineTest::rowsStandAtMultiplesOfTheSample_data() {
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

void CommandLineTest::rowsStandAtMultiplesOfTheSample() {
  QFETCH(QString, until);
  QFETCH(QString, sample);
  QFETCH(QByteArrayList, times);
  const Table table =
      tableIn(rowsOf({m_thrown, "--until", until, "--sample", sample, "--energy", "-"}));
  QCOMPARE(table.column(0), times);
}

void CommandLineTest::samplingNeverChangesTheRun() {
  const auto rows = [this](const char* sample) {
    return tableIn(
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

void CommandLineTest::cutOptionOverridesTheScene() {
  const auto phaseAtEnd = [this](const char* cut) {
    const Table table = tableIn(rowsOf(
        {m_hanging, "--until", "0.5", "--sample", "0.5", "--cut", cut, "--trajectory", "-"}));
    return table.rows[2][2];
  };
  QCOMPARE(phaseAtEnd("never"), QByteArray("tethered"));
  QCOMPARE(phaseAtEnd("0.4"), QByteArray("flying"));
  QCOMPARE(phaseAtEnd("0"), QByteArray("flying"));
  QCOMPARE(phaseAtEnd("0.6"), QByteArray("tethered"));
}

void CommandLineTest::methodAndStepDecideTheRun() {
  const auto heightAtEnd = [this](const char* method, const char* step) {
    const Table table = tableIn(rowsOf({m_thrown, "--until", "0.5", "--sample", "0.5", "--method",
                                        method, "--step", step, "--trajectory", "-"}));
    return table.rows[1][4].toDouble();
  };
  // Euler's parabola lies g h t / 2 above the true one.
  QVERIFY(std::abs(heightAtEnd("euler", "0.1") - (4.25 + 0.25)) < 1e-12);
  QVERIFY(std::abs(heightAtEnd("euler", "0.05") - (4.25 + 0.125)) < 1e-12);
  QVERIFY(std::abs(heightAtEnd("rk4", "0.1") - 4.25) < 1e-12);
}

void CommandLineTest::writesNumbersTheSameInEveryLocale() {
  const QStringList call{"simulate", m_thrown, "--until", "0.5", "--trajectory", "-"};
  QCOMPARE(run(call, {{"LC_ALL", "de_DE.UTF-8"}, {"LANG", "de_DE.UTF-8"}}).output,
           run(call).output);
}

void CommandLineTest::standardOutputTakesOneTable() {
  const Outcome outcome = run({"simulate", m_thrown, "--until", "1", "--energy", "-",
                               "--trajectory", path("trajectory.csv")});
  QCOMPARE(outcome.status, 0);
  QCOMPARE(tableIn(outcome.output).rows.size(), 11);
  QCOMPARE(tableIn(contentOf(path("trajectory.csv"))).rows.size(), 11);
}

void CommandLineTest::printsAShortTableWhereNoFileIsWanted() {
  const Outcome outcome = run({"simulate", m_thrown});
  QCOMPARE(outcome.status, 0);
  QCOMPARE(outcome.error, QByteArray());
  QVERIFY(outcome.output.contains("kinetic"));
  QCOMPARE(outcome.output.count('\n'), 2 + 11);  // what it is, columns, rows
}

void CommandLineTest::writesTheEnergyChart_data() {
  QTest::addColumn<QString>("ending");
  QTest::addColumn<QByteArray>("start");
  QTest::newRow("png") << "png" << QByteArray("\x89PNG");
  QTest::newRow("svg") << "svg" << QByteArray("<?xml");
  QTest::newRow("pdf") << "PDF" << QByteArray("%PDF");
}

void CommandLineTest::writesTheEnergyChart() {
  QFETCH(QString, ending);
  QFETCH(QByteArray, start);
  const QString file = path("chart." + ending);
  const Outcome outcome = run({"simulate", m_hanging, "--until", "2", "--chart", file});
  QCOMPARE(outcome.status, 0);
  QCOMPARE(outcome.output + outcome.error, QByteArray());
  QVERIFY(contentOf(file).startsWith(start));
}

void CommandLineTest::simulatesBuiltInScenesByName() {
  for (const QString& name : ui::builtInScenes()) {
    const Table table = tableIn(rowsOf({name, "--until", "0", "--trajectory", "-"}));
    QCOMPARE(static_cast<std::size_t>(table.rows.size()), ui::builtInScene(name).weights.size());
  }
}

void CommandLineTest::refusesCalls_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("error");
  const auto row = [](const char* name, const char* arguments, const char* error) {
    QTest::newRow(name) << QString(arguments).split(' ') << QByteArray(error);
  };
  row("unknown command", "animate one-pendulum", "unknown command \"animate\"");
  row("unknown scene", "simulate no-such", "no-such: no file or built-in scene of that name");
  row("unknown scene for the window", "no-such", "no-such: no file or built-in scene of that name");
  row("no scene", "simulate", "simulate: a scene must be named");
  row("two scenes", "simulate one-pendulum two-weights", "unexpected argument \"two-weights\"");
  row("argument behind scenes", "scenes all", "unexpected argument \"all\"");
  row("unknown option", "simulate one-pendulum --foo", "Unknown option 'foo'.");
  row("option of another call", "scenes --until 1", "Unknown option 'until'.");
  row("no value", "simulate one-pendulum --until", "Missing value after '--until'.");
  row("twice", "simulate one-pendulum --step 1 --step 2", "--step: stands twice");
  row("unknown method", "simulate one-pendulum --method magic",
      "--method: must be one of euler, semi-implicit-euler, rk4, dopri5, got \"magic\"");
  row("method of the program's own", "simulate one-pendulum --method reference",
      "--method: must be one of euler, semi-implicit-euler, rk4, dopri5, got \"reference\"");
  row("step of a method with a tolerance", "simulate one-pendulum --method dopri5 --step 0.1",
      "--step: dopri5 takes a tolerance, not a step");
  row("tolerance", "simulate one-pendulum --tolerance 1e-9",
      "--tolerance: rk4 takes a step, not a tolerance");
  row("tolerance out of range", "simulate one-pendulum --tolerance 2",
      "--tolerance: must be from 1e-14 to 1, got 2");
  row("step too large", "simulate one-pendulum --step 20",
      "--step: must be from 1e-7 to 10 s, got 20");
  row("step too small", "simulate one-pendulum --step 1e-8",
      "--step: must be from 1e-7 to 10 s, got 1e-8");
  row("until too large", "simulate one-pendulum --until 2e6",
      "--until: must be from 0 to 1000000 s, got 2000000");
  row("until below zero", "simulate one-pendulum --until -1",
      "--until: must be from 0 to 1000000 s, got -1");
  row("sample zero", "simulate one-pendulum --sample 0",
      "--sample: must be from 1e-7 to 1000000 s, got 0");
  row("cut below zero", "simulate one-pendulum --cut -1", "--cut: must be at least 0 s, got -1");
  row("cut in words", "simulate one-pendulum --cut soon", "--cut: must be a number, got \"soon\"");
  row("decimal comma", "simulate one-pendulum --step 0,1", "--step: must be a number, got \"0,1\"");
  row("unit", "simulate one-pendulum --step 0.1s", "--step: must be a number, got \"0.1s\"");
  row("infinity", "simulate one-pendulum --until inf", "--until: must be a number, got \"inf\"");
  row("not a number", "simulate one-pendulum --until nan",
      "--until: must be a number, got \"nan\"");
  row("picture of another kind", "simulate one-pendulum --chart chart.gif",
      "--chart: must end in .png, .svg or .pdf, got \"chart.gif\"");
  row("chart on standard output", "simulate one-pendulum --chart -",
      "--chart: must end in .png, .svg or .pdf, got \"-\"");
  row("standard output twice", "simulate one-pendulum --energy - --events -",
      "--events: - is used twice");
  row("file twice", "simulate one-pendulum --energy rows.csv --trajectory ./rows.csv",
      "--energy: rows.csv is used twice");
  row("over the scene", "simulate thrown.json --events thrown.json",
      "--events: thrown.json is used twice");
  QTest::newRow("no name") << QStringList{"simulate", "one-pendulum", "--events", ""}
                           << QByteArray("--events: must be a name");
}

void CommandLineTest::refusesCalls() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, error);
  const Outcome outcome = run(arguments);
  QCOMPARE(outcome.error, "angrycuts: " + error + '\n');
  QCOMPARE(outcome.status, 2);
  QCOMPARE(outcome.output, QByteArray());
}

void CommandLineTest::refusesScenesWithTheirPlace() {
  const QString file = write("refused.json", R"({"format": "angry-cuts/scene", "version": 1,
      "weights": [{"rope": {"pivot": [1, 1], "length": -1}}]})");
  const Outcome outcome = run({"simulate", file});
  QCOMPARE(outcome.status, 2);
  QCOMPARE(outcome.error, "angrycuts: " + file.toUtf8() +
                              ": weights[0].rope.length: must be from 0.001 to 10000 m, got -1\n");
}

void CommandLineTest::divergesWithTheRowsUntilThen() {
  const Outcome outcome = run({"simulate", m_exploding, "--method", "euler", "--step", "0.1",
                               "--sample", "0.1", "--energy", "-"});
  QCOMPARE(outcome.status, 3);
  QVERIFY2(QRegularExpression("\\Aangrycuts: diverged at [0-9.]+ s: .*step.*\n\\z")
               .match(outcome.error)
               .hasMatch(),
           outcome.error);
  const Table table = tableIn(outcome.output);
  QVERIFY(!table.rows.isEmpty());
  for (const QByteArrayList& row : table.rows) {
    for (const QByteArray& field : row) {
      bool isNumber = false;
      QVERIFY(std::isfinite(field.toDouble(&isNumber)));
      QVERIFY(isNumber);
    }
  }
}

void CommandLineTest::suggestsAStepThatWorks() {
  const QStringList call{
      "simulate", write("thick-air.json", kThickAir), "--method", "euler", "--until", "100",
      "--step"};
  const Outcome diverged = run(call + QStringList{"0.5"});
  QCOMPARE(diverged.status, 3);
  const auto line = QRegularExpression(
                        "\\Aangrycuts: diverged at ([0-9.]+) s: .*; --step "
                        "([0-9.]+) works\n\\z")
                        .match(diverged.error);
  QVERIFY2(line.hasMatch(), diverged.error);
  QVERIFY(line.captured(1).toDouble() < 100);
  QVERIFY(line.captured(2).toDouble() <= 1.0 / 15);
  QVERIFY(line.captured(2).toDouble() > 0.06);
  QCOMPARE(run(call + QStringList{line.captured(2)}).status, 0);
}

void CommandLineTest::saysWhenAFileCannotBeWritten() {
  for (const char* option : {"--trajectory", "--energy", "--events"}) {
    const Outcome outcome = run({"simulate", m_thrown, option, "none/rows.csv"});
    QCOMPARE(outcome.status, 1);
    QCOMPARE(outcome.error, QByteArray("angrycuts: none/rows.csv: No such file or directory\n"));
  }
  const Outcome outcome = run({"simulate", m_thrown, "--chart", "none/chart.png"});
  QCOMPARE(outcome.status, 1);
  QCOMPARE(outcome.error, QByteArray("angrycuts: none/chart.png: No such file or directory\n"));
}

void CommandLineTest::opensItsFilesBeforeItSimulates() {
  // Simulating that long would take minutes; the call ends at once.
  QElapsedTimer timer;
  timer.start();
  const Outcome outcome = run({"simulate", "seven-weights", "--until", "1e6", "--step", "1e-4",
                               "--energy", "-", "--chart", "none/chart.png"});
  QCOMPARE(outcome.status, 1);
  QVERIFY(timer.elapsed() < 30'000);
}

void CommandLineTest::noticesAFullDisk() {
  const Outcome file = run({"simulate", m_thrown, "--energy", "/dev/full"});
  QCOMPARE(file.status, 1);
  QCOMPARE(file.error, QByteArray("angrycuts: /dev/full: No space left on device\n"));

  for (const char* call : {"simulate thrown.json --energy -", "simulate thrown.json", "scenes",
                           "--help", "--version"}) {
    const Outcome output = runInShell(QString("\"$1\" %1 >/dev/full").arg(call));
    QCOMPARE(output.status, 1);
    QCOMPARE(output.error, QByteArray("angrycuts: standard output: No space left on device\n"));
  }
}

void CommandLineTest::noticesAClosedPipe() {
  const Outcome outcome = runInShell(
      "\"$1\" simulate thrown.json --until 1000 --sample 0.001 --trajectory - | head -n 1; "
      "exit ${PIPESTATUS[0]}");
  QCOMPARE(outcome.status, 1);
  QCOMPARE(outcome.error, QByteArray("angrycuts: standard output: Broken pipe\n"));
  QCOMPARE(outcome.output.count('\n'), 1);
}

void CommandLineTest::leavesOldFilesWhereItFails() {
  const QString file = write("old.csv", "old");
  const Outcome outcome = runInShell(
      "trap '' XFSZ; ulimit -f 1; \"$1\" simulate thrown.json --until 100 --trajectory old.csv");
  QCOMPARE(outcome.status, 1);
  QCOMPARE(outcome.error, QByteArray("angrycuts: old.csv: File too large\n"));
  QCOMPARE(contentOf(file), QByteArray("old"));
}

void CommandLineTest::showsWhatItCanWithoutADisplay() {
  const Outcome outcome = run({"seven-weights"});
  QCOMPARE(outcome.error, QByteArray());
  QCOMPARE(outcome.status, 0);
  for (const char* name : {"angrycuts-energy.png", "angrycuts-scene.png"}) {
    QVERIFY2(outcome.output.contains(name), name);
    QVERIFY2(contentOf(path(name)).startsWith("\x89PNG"), name);
  }
  QVERIFY(outcome.output.contains("angrycuts-trajectory.csv"));
  QCOMPARE(tableIn(contentOf(path("angrycuts-trajectory.csv"))).rows.size(), 101 * 7);
}

QTEST_GUILESS_MAIN(CommandLineTest)
#include "command_line_test.moc"
