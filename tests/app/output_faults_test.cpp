#include <QtTest>

#include "tests/app/thrown_scene.h"
#include "tests/support/called_program.h"
#include "tests/support/file_content.h"

using tests::contentOf;
using tests::Outcome;

/// The program called where its output cannot go.
class OutputFaultsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void saysWhenAFileCannotBeWritten();
  void opensItsFilesBeforeItSimulates();
  void noticesAFullDisk();
  void noticesAClosedPipe();
  void leavesOldFilesWhereItFails();

 private:
  tests::CalledProgram m_program{ANGRYCUTS_PROGRAM};
  QString m_thrown;
};

void OutputFaultsTest::initTestCase() {
  m_thrown = m_program.write("thrown.json", tests::kThrown);
}

void OutputFaultsTest::saysWhenAFileCannotBeWritten() {
  for (const char* option : {"--trajectory", "--energy", "--events"}) {
    const Outcome outcome = m_program.call({"simulate", m_thrown, option, "none/rows.csv"});
    QCOMPARE(outcome.status, 1);
    QCOMPARE(outcome.error, QByteArray("angrycuts: none/rows.csv: No such file or directory\n"));
  }
  const Outcome outcome = m_program.call({"simulate", m_thrown, "--chart", "none/chart.png"});
  QCOMPARE(outcome.status, 1);
  QCOMPARE(outcome.error, QByteArray("angrycuts: none/chart.png: No such file or directory\n"));
}

void OutputFaultsTest::opensItsFilesBeforeItSimulates() {
  // Simulating that long would take hours, and a call that takes minutes has no status.
  const Outcome outcome = m_program.call({"simulate", "seven-weights", "--until", "1e6", "--step",
                                          "1e-4", "--energy", "-", "--chart", "none/chart.png"});
  QCOMPARE(outcome.status, 1);
}

void OutputFaultsTest::noticesAFullDisk() {
  const Outcome file = m_program.call({"simulate", m_thrown, "--energy", "/dev/full"});
  QCOMPARE(file.status, 1);
  QCOMPARE(file.error, QByteArray("angrycuts: /dev/full: No space left on device\n"));

  for (const char* call : {"simulate thrown.json --energy -", "simulate thrown.json", "scenes",
                           "--help", "--version"}) {
    const Outcome output = m_program.callInShell(QString("\"$1\" %1 >/dev/full").arg(call));
    QCOMPARE(output.status, 1);
    QCOMPARE(output.error, QByteArray("angrycuts: standard output: No space left on device\n"));
  }
}

void OutputFaultsTest::noticesAClosedPipe() {
  const Outcome outcome = m_program.callInShell(
      "\"$1\" simulate thrown.json --until 1000 --sample 0.001 --trajectory - | head -n 1; "
      "exit ${PIPESTATUS[0]}");
  QCOMPARE(outcome.status, 1);
  QCOMPARE(outcome.error, QByteArray("angrycuts: standard output: Broken pipe\n"));
  QCOMPARE(outcome.output.count('\n'), 1);
}

void OutputFaultsTest::leavesOldFilesWhereItFails() {
  const QString file = m_program.write("old.csv", "old");
  const Outcome outcome = m_program.callInShell(
      "trap '' XFSZ; ulimit -f 1; \"$1\" simulate thrown.json --until 100 --trajectory old.csv");
  QCOMPARE(outcome.status, 1);
  QCOMPARE(outcome.error, QByteArray("angrycuts: old.csv: File too large\n"));
  QCOMPARE(contentOf(file), QByteArray("old"));
}

QTEST_GUILESS_MAIN(OutputFaultsTest)
#include "output_faults_test.moc"
