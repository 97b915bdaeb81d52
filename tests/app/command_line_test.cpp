#include <QtTest>

#include "tests/app/thrown_scene.h"
#include "tests/support/called_program.h"
#include "tests/support/csv_table.h"
#include "tests/support/file_content.h"

using tests::contentOf;
using tests::csvTableIn;
using tests::Outcome;

/// What all calls of the program share.
class CommandLineTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void helpNamesEveryCallAndOption();
  void helpNamesEveryMethodAndNoOther();
  void versionIsOneLine();
  void refusesCalls_data();
  void refusesCalls();
  void refusesScenesWithTheirPlace();
  void speaksTheLanguageOfTheEnvironment();
  void saysWhatIsNotAllowedInTheReadersLanguage_data();
  void saysWhatIsNotAllowedInTheReadersLanguage();
  void showsWhatItCanWithoutADisplay();

 private:
  tests::CalledProgram m_program{ANGRYCUTS_PROGRAM};
};

void CommandLineTest::initTestCase() {
  m_program.write("thrown.json", tests::kThrown);
}

void CommandLineTest::helpNamesEveryCallAndOption() {
  const Outcome outcome = m_program.call({"--help"});
  QCOMPARE(outcome.status, 0);
  QCOMPARE(outcome.error, QByteArray());
  for (const char* word :
       {"angrycuts [SCENE]", "scenes", "--export", "simulate", "measure", "--csv", "--method",
        "--step", "--tolerance", "--until", "--cut", "--sample", "--trajectory", "--energy",
        "--events", "--chart", "--version"}) {
    QVERIFY2(outcome.output.contains(word), word);
  }
  QCOMPARE(m_program.call({"simulate", "--help"}).output, outcome.output);
}

void CommandLineTest::helpNamesEveryMethodAndNoOther() {
  const QByteArray help = m_program.call({"--help"}).output;
  QVERIFY(help.contains("  --method NAME        euler, semi-implicit-euler, rk4, dopri5 (rk4)\n"));
  QVERIFY(!help.contains("reference"));
}

void CommandLineTest::versionIsOneLine() {
  const Outcome outcome = m_program.call({"--version"});
  QCOMPARE(outcome.status, 0);
  QVERIFY(
      QRegularExpression("\\Aangrycuts \\d+\\.\\d+\\.\\d+\n\\z").match(outcome.output).hasMatch());
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
  const Outcome outcome = m_program.call(arguments);
  QCOMPARE(outcome.error, "angrycuts: " + error + '\n');
  QCOMPARE(outcome.status, 2);
  QCOMPARE(outcome.output, QByteArray());
}

void CommandLineTest::refusesScenesWithTheirPlace() {
  const QString file =
      m_program.write("refused.json", R"({"format": "angry-cuts/scene", "version": 1,
      "weights": [{"rope": {"pivot": [1, 1], "length": -1}}]})");
  const Outcome outcome = m_program.call({"simulate", file});
  QCOMPARE(outcome.status, 2);
  QCOMPARE(outcome.error, "angrycuts: " + file.toUtf8() +
                              ": weights[0].rope.length: must be from 0.001 to 10000 m, got -1\n");
}

void CommandLineTest::speaksTheLanguageOfTheEnvironment() {
  const Outcome swedish = m_program.call({"explain"}, {{"LC_ALL", "sv_SE.UTF-8"}});
  QCOMPARE(swedish.status, 2);
  QVERIFY2(swedish.error.startsWith("angrycuts: explain: ingen fil"), swedish.error);
  QVERIFY(m_program.call({"--help"}, {{"LC_ALL", "de_DE.UTF-8"}}).output.contains("Fenster"));
  // One that it does not know is answered in English, and numbers are those of files.
  const QString file = m_program.write("bad.json", R"({"format": "angry-cuts/scene", "version": 1,
      "gravity": -0.5})");
  const Outcome icelandic = m_program.call({"simulate", file}, {{"LC_ALL", "is_IS.UTF-8"}});
  QVERIFY2(icelandic.error.contains("must be from"), icelandic.error);
  const Outcome french = m_program.call({"simulate", file}, {{"LC_ALL", "fr_FR.UTF-8"}});
  QVERIFY2(french.error.contains("-0.5"), french.error);
}

void CommandLineTest::saysWhatIsNotAllowedInTheReadersLanguage_data() {
  QTest::addColumn<QString>("environment");
  QTest::addColumn<QByteArray>("option");
  QTest::addColumn<QByteArray>("scene");
  QTest::addColumn<QByteArray>("unknown");
  QTest::newRow("English") << "C.UTF-8" << QByteArray("--step: must be from 1e-7 to 10 s, got 20")
                           << QByteArray(
                                  "weights[0].rope.length: must be from 0.001 to 10000 m, "
                                  "got -1")
                           << QByteArray("Unknown option 'frob'.");
  QTest::newRow("Swedish") << "sv_SE.UTF-8"
                           << QByteArray("--step: måste vara från 1e-7 till 10 s, är 20")
                           << QByteArray(
                                  "weights[0].rope.length: måste vara från 0.001 till "
                                  "10000 m, är -1")
                           << QByteArray("Okänt alternativ ”frob”.");
  QTest::newRow("German") << "de_DE.UTF-8"
                          << QByteArray("--step: muss von 1e-7 bis 10 s sein, ist aber 20")
                          << QByteArray(
                                 "weights[0].rope.length: muss von 0.001 bis 10000 m sein, "
                                 "ist aber -1")
                          << QByteArray("Unbekannte Option „frob“.");
  QTest::newRow("French") << "fr_FR.UTF-8"
                          << QByteArray("--step: attendu\u00a0: de 1e-7 à 10 s\u00a0; lu\u00a0: 20")
                          << QByteArray(
                                 "weights[0].rope.length: attendu\u00a0: de 0.001 à 10000 m\u00a0; "
                                 "lu\u00a0: -1")
                          << QByteArray("Option inconnue «\u00a0frob\u00a0».");
  QTest::newRow("Spanish") << "es_ES.UTF-8"
                           << QByteArray("--step: se esperaba de 1e-7 a 10 s, no 20")
                           << QByteArray(
                                  "weights[0].rope.length: se esperaba de 0.001 a 10000 m, "
                                  "no -1")
                           << QByteArray("Opción desconocida «frob».");
}

void CommandLineTest::saysWhatIsNotAllowedInTheReadersLanguage() {
  QFETCH(QString, environment);
  QFETCH(QByteArray, option);
  QFETCH(QByteArray, scene);
  QFETCH(QByteArray, unknown);
  const auto said = [&](const QStringList& call) {
    return m_program.call(call, {{"LC_ALL", environment}}).error;
  };
  QCOMPARE(said({"simulate", "one-pendulum", "--step", "20"}), "angrycuts: " + option + '\n');
  const QString file = m_program.write("short.json", R"({"format": "angry-cuts/scene", "version": 1,
      "weights": [{"rope": {"pivot": [1, 1], "length": -1}}]})");
  QCOMPARE(said({"simulate", file}), "angrycuts: " + file.toUtf8() + ": " + scene + '\n');
  QCOMPARE(said({"--frob"}), "angrycuts: " + unknown + '\n');
}

void CommandLineTest::showsWhatItCanWithoutADisplay() {
  const Outcome outcome = m_program.call({"seven-weights"});
  QCOMPARE(outcome.error, QByteArray());
  QCOMPARE(outcome.status, 0);
  for (const char* name : {"angrycuts-energy.png", "angrycuts-scene.png"}) {
    QVERIFY2(outcome.output.contains(name), name);
    QVERIFY2(contentOf(m_program.path(name)).startsWith("\x89PNG"), name);
  }
  QVERIFY(outcome.output.contains("angrycuts-trajectory.csv"));
  QCOMPARE(csvTableIn(contentOf(m_program.path("angrycuts-trajectory.csv"))).rows.size(), 101 * 7);
}

QTEST_GUILESS_MAIN(CommandLineTest)
#include "command_line_test.moc"
