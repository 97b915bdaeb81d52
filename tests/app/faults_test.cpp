// What the commands do where disks are full, folders cannot be written to, pipes are closed, and
// the surroundings are not what they should be. Nothing here depends on permissions: root has
// them all.

#include <QtTest>

#include "ui/files/scene_file.h"

namespace {

/// What a call of the program left behind.
struct Outcome {
  int status = -1;
  QByteArray output;
  QByteArray error;
};

QByteArray contentOf(const QString& file) {
  QFile input(file);
  return input.open(QIODevice::ReadOnly) ? input.readAll() : QByteArray("cannot be read");
}

}  // namespace

class FaultsTest : public QObject {
  Q_OBJECT

 private slots:
  void init();

  void saysThatTheDiskIsFull_data();
  void saysThatTheDiskIsFull();
  void saysThatAFolderIsReadOnly_data();
  void saysThatAFolderIsReadOnly();
  void saysThatThePipeIsClosed_data();
  void saysThatThePipeIsClosed();
  void saysThatTheFolderIsGone();
  void writesThroughLinks();
  void readsAndWritesPipes();
  void refusesWhatIsNoScene_data();
  void refusesWhatIsNoScene();
  void runsInStrangeSurroundings_data();
  void runsInStrangeSurroundings();
  void saysWhichDisplayDoesNotAnswer();

 private:
  Outcome run(const QString& command) const;
  QString path(const QString& name) const { return m_folder->filePath(name); }

  std::unique_ptr<QTemporaryDir> m_folder;
};

void FaultsTest::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(ui::writeSceneFile(path("scene.json"), ui::builtInScene("two-weights")).isEmpty());
}

/// @param command  of a shell; the program is $1, this test's folder the working directory. Its
///                 status is that of the first program in a pipe
Outcome FaultsTest::run(const QString& command) const {
  QProcess process;
  process.setWorkingDirectory(m_folder->path());
  process.start("bash", {"-c", command + "\nexit ${PIPESTATUS[0]}", "bash", ANGRYCUTS_PROGRAM});
  process.waitForFinished(60'000);
  return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

void FaultsTest::saysThatTheDiskIsFull_data() {
  QTest::addColumn<QString>("call");
  QTest::addColumn<QString>("file");
  const auto row = [](const char* call, const char* file) {
    QTest::newRow(call) << QString(call) << QString(file);
  };
  row("simulate scene.json --until 100 --trajectory rows.csv", "rows.csv");
  row("simulate scene.json --until 100 --energy rows.csv", "rows.csv");
  row("simulate scene.json --until 1 --chart chart.png", "chart.png");
  row("simulate scene.json --until 1 --chart chart.svg", "chart.svg");
  row("simulate scene.json --until 1 --chart chart.pdf", "chart.pdf");
  row("measure scene.json --until 0.1 --csv rows.csv", "rows.csv");
  row("measure scene.json --until 0.1 --chart chart.png", "chart.png");
  row("scenes --export .", "./thousand-pendulums.json");
  row("scene.json", "angrycuts-scene.png");
}

void FaultsTest::saysThatTheDiskIsFull() {
  QFETCH(QString, call);
  QFETCH(QString, file);
  QFile old(path(file));
  QVERIFY(old.open(QIODevice::WriteOnly));
  old.write("old");
  old.close();
  // Blocks of 1024 bytes.
  const Outcome outcome =
      run("unset DISPLAY WAYLAND_DISPLAY; trap '' XFSZ; ulimit -f 2; \"$1\" " + call);
  QCOMPARE(outcome.error, "angrycuts: " + file.toUtf8() + ": File too large\n");
  QCOMPARE(outcome.status, 1);
  QCOMPARE(contentOf(path(file)), QByteArray("old"));
}

void FaultsTest::saysThatAFolderIsReadOnly_data() {
  QTest::addColumn<QString>("call");
  QTest::addColumn<QString>("file");
  const auto row = [](const char* call, const char* file) {
    QTest::newRow(call) << QString(call) << QString(file);
  };
  for (const char* option : {"--trajectory", "--energy", "--events"}) {
    QTest::newRow(option) << QString("simulate pile %1 /dev/pts/rows.csv").arg(option)
                          << "/dev/pts/rows.csv";
  }
  row("simulate pile --chart /dev/pts/chart.png", "/dev/pts/chart.png");
  row("measure pile --csv /dev/pts/rows.csv", "/dev/pts/rows.csv");
  row("measure pile --chart /dev/pts/chart.svg", "/dev/pts/chart.svg");
  row("scenes --export /dev/pts", "/dev/pts/one-pendulum.json");
  row("scenes --export /dev/pts/folder", "/dev/pts/folder");
  row("pile", "angrycuts-trajectory.csv");
}

void FaultsTest::saysThatAFolderIsReadOnly() {
  QFETCH(QString, call);
  QFETCH(QString, file);
  const Outcome outcome = run("unset DISPLAY WAYLAND_DISPLAY; cd /dev/pts; \"$1\" " + call);
  const QString line = "\\Aangrycuts: " + QRegularExpression::escape(file) +
                       ": (Permission denied|Read-only file system|the folder cannot be made)\n\\z";
  QVERIFY2(QRegularExpression(line).match(outcome.error).hasMatch(), outcome.error);
  QCOMPARE(outcome.status, 1);
  QCOMPARE(outcome.output, QByteArray());
}

void FaultsTest::saysThatThePipeIsClosed_data() {
  QTest::addColumn<QString>("call");
  for (const char* call :
       {"simulate scene.json", "simulate scene.json --until 1000 --sample 0.001 --energy -",
        "simulate scene.json --until 1000 --sample 0.001 --trajectory -",
        "measure scene.json --until 0.1 --csv -", "scenes", "--help", "--version"}) {
    QTest::newRow(call) << QString(call);
  }
}

void FaultsTest::saysThatThePipeIsClosed() {
  QFETCH(QString, call);
  // The reader is gone before the first byte: it says so by the file.
  const Outcome outcome = run(
      QString("{ until [ -e gone ]; do sleep 0.01; done; \"$1\" %1; } | { exec <&-; touch gone; }")
          .arg(call));
  QCOMPARE(outcome.error, QByteArray("angrycuts: standard output: Broken pipe\n"));
  QCOMPARE(outcome.status, 1);
}

void FaultsTest::saysThatTheFolderIsGone() {
  QVERIFY(QDir(m_folder->path()).mkdir("gone"));
  // Once rows arrive the program is at work, and its other file open.
  const Outcome outcome =
      run("\"$1\" simulate scene.json --until 100 --sample 0.001 --events gone/events.csv "
          "--trajectory - | { head -c 1000 >/dev/null; rm -r gone; cat >/dev/null; }");
  QCOMPARE(outcome.error, QByteArray("angrycuts: gone/events.csv: No such file or directory\n"));
  QCOMPARE(outcome.status, 1);
}

void FaultsTest::writesThroughLinks() {
  QVERIFY(QDir(m_folder->path()).mkdir("other"));
  const Outcome outcome =
      run("echo old >other/target.csv; ln -s other/target.csv near.csv; ln -s near.csv far.csv; "
          "ln -s other/new.csv dangling.csv; "
          "\"$1\" simulate scene.json --until 1 --energy far.csv --events dangling.csv; status=$?; "
          "readlink near.csv far.csv dangling.csv; (exit $status)");
  QCOMPARE(outcome.error, QByteArray());
  QCOMPARE(outcome.status, 0);
  QCOMPARE(outcome.output, QByteArray("other/target.csv\nnear.csv\nother/new.csv\n"));
  QVERIFY(contentOf(path("other/target.csv")).startsWith("time,kinetic"));
  QVERIFY(contentOf(path("other/new.csv")).startsWith("time,event"));
}

void FaultsTest::readsAndWritesPipes() {
  const Outcome direct = run("\"$1\" simulate scene.json --until 1 --energy -");
  const Outcome piped = run("\"$1\" simulate <(cat scene.json) --until 1 --energy >(cat) | cat");
  QCOMPARE(piped.error, QByteArray());
  QCOMPARE(piped.output, direct.output);
  QVERIFY(direct.output.startsWith("time,kinetic"));
}

void FaultsTest::refusesWhatIsNoScene_data() {
  QTest::addColumn<QString>("prepare");
  QTest::addColumn<QString>("file");
  QTest::addColumn<QByteArray>("reason");
  const auto row = [](const char* name, const char* prepare, const char* file, const char* reason) {
    QTest::newRow(name) << QString(prepare) << QString(file) << QByteArray(reason);
  };
  row("folder", "mkdir -p folder", "folder", "file to open is a directory");
  row("empty", ": >empty.json", "empty.json", "the file is empty");
  row("device that fails", "", "/proc/self/mem", "Input/output error");
  row("device without end", "", "/dev/zero", "larger than 64 MiB");
  row("UTF-16", "iconv -t UTF-16 scene.json >utf16.json", "utf16.json",
      "not UTF-8 but UTF-16; save it as UTF-8");
  row("half a file", "head -c 200 scene.json >half.json", "half.json",
      "not JSON: line 5, column 126: the text ends inside a string");
  row("line of a megabyte", "head -c 1048576 /dev/zero | tr '\\0' '[' >long.json", "long.json",
      "scene: must be an object, got a list");
}

void FaultsTest::refusesWhatIsNoScene() {
  QFETCH(QString, prepare);
  QFETCH(QString, file);
  QFETCH(QByteArray, reason);
  for (const char* call : {"simulate", "measure"}) {
    const Outcome outcome = run(QString("%1\n\"$1\" %2 %3").arg(prepare, call, file));
    QCOMPARE(outcome.error, "angrycuts: " + file.toUtf8() + ": " + reason + '\n');
    QCOMPARE(outcome.status, 2);
    QCOMPARE(outcome.output, QByteArray());
  }
}

void FaultsTest::runsInStrangeSurroundings_data() {
  QTest::addColumn<QString>("prepare");
  const auto row = [](const char* name, const char* prepare) {
    QTest::newRow(name) << QString(prepare);
  };
  row("unknown locale", "{ export LC_ALL=xx_YY.nonsense LANG=tlh LANGUAGE=none; } 2>/dev/null");
  row("plain C locale", "export LC_ALL=C");
  row("no home", "unset HOME XDG_CONFIG_HOME XDG_DATA_HOME XDG_CACHE_HOME XDG_RUNTIME_DIR");
  row("home that is not there", "export HOME=/none XDG_CONFIG_HOME=/none XDG_DATA_HOME=/none");
  row("settings that are a device", "export XDG_CONFIG_HOME=/dev/null");
  row("nothing at all", "exec env -i \"$0\" -c 'cd \"$2\" && . ./call' bash \"$1\" \"$PWD\"");
  row("standard input closed", "exec 0<&-");
}

void FaultsTest::runsInStrangeSurroundings() {
  QFETCH(QString, prepare);
  const QString call =
      "\"$1\" simulate scene.json --until 1 --energy 'energí ≠.csv' --trajectory - --chart c.png";
  QFile file(path("call"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(call.toUtf8());
  file.close();
  const Outcome usual = run(call);
  const QByteArray energy = contentOf(path("energí ≠.csv"));
  QVERIFY(energy.startsWith("time,kinetic"));
  QVERIFY(QFile::remove(path("energí ≠.csv")));
  const Outcome strange = run(prepare + '\n' + call);
  QCOMPARE(strange.error, QByteArray());
  QCOMPARE(strange.status, 0);
  QCOMPARE(strange.output, usual.output);
  QCOMPARE(contentOf(path("energí ≠.csv")), energy);
}

void FaultsTest::saysWhichDisplayDoesNotAnswer() {
  const Outcome outcome =
      run("unset QT_QPA_PLATFORM WAYLAND_DISPLAY; export DISPLAY=:9999; \"$1\" scene.json");
  QCOMPARE(outcome.status, 1);
  QCOMPARE(outcome.output, QByteArray());
  QCOMPARE(outcome.error.trimmed().split('\n').last(),
           QByteArray("angrycuts: the window cannot be opened: no display answers "
                      "(DISPLAY=:9999)"));
}

QTEST_GUILESS_MAIN(FaultsTest)
#include "faults_test.moc"
