// Kills programs while they write, at random moments: no file is ever half. ANGRYCUTS_KILLS says
// how many (10); the campaign, tests/faults, kills 200.

#include <cstdio>
#include <functional>

#include <QApplication>
#include <QProcess>
#include <QRandomGenerator>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

#include "tests/support/crowded_file.h"
#include "ui/control/exports.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/control/settings.h"
#include "ui/files/draft_file.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"

namespace {

constexpr int kWeights = 2000;  // so that writing takes a while

core::Scene crowd() {
  core::Scene scene = *ui::parseScene(oneLineOf(kWeights)).scene;
  scene.solvers = {{.method = "rk4"}};
  return scene;
}

QByteArray contentOf(const QString& file) {
  QFile input(file);
  return input.open(QIODevice::ReadOnly) ? input.readAll() : QByteArray();
}

/// Does the same again and again until it is killed, and says when it begins and ends.
[[noreturn]] void repeat(const std::function<void(int)>& work) {
  for (int round = 1;; ++round) {
    std::fputc('(', stdout);
    std::fflush(stdout);
    work(round);
    std::fputc(')', stdout);
    std::fflush(stdout);
  }
}

void setGravity(ui::SceneEditor& editor, int round) {
  editor.change([round](core::Scene& draft) { draft.gravity = round % 1000; });
}

/// What runs in a process of its own, to be killed.
[[noreturn]] void runVictim(const QString& kind, const QString& folder) {
  const QString file = folder + '/' + kind;
  if (kind.endsWith("angrycuts.conf")) {
    repeat([](int round) {
      ui::Settings settings;
      settings.setSpeed(round % 1000 + 1);
      settings.setRecentFiles(QStringList(kWeights, QString::number(round % 1000 + 1)));
    });
  }
  if (kind == "one.draft") {
    repeat([&](int round) {
      core::Scene scene = crowd();
      scene.gravity = round % 1000;
      ui::writeDraftFile(file, {"", scene, scene});
    });
  }
  const bool isScene = kind == "scene.json";
  ui::MainWindow window(isScene ? crowd() : ui::builtInScene("seven-weights"));
  if (isScene) {
    repeat([&](int round) {
      setGravity(*window.editor(), round);
      window.files()->saveTo(file);
    });
  }
  repeat([&](int) { window.exports()->savePicture(file); });
}

/// Whether a file that a kill left is whole.
using IsWhole = std::function<bool(const QString& file)>;

bool isWholeScene(const QString& file) {
  const ui::SceneOrError read = ui::readSceneFile(file);
  return read.scene && ui::sceneText(*read.scene) == contentOf(file);
}

bool isWholeDraft(const QString& file) {
  const auto kept = ui::readDraftFile(file);
  return kept && kept->draft && kept->scene == *kept->draft;
}

bool areWholeSettings(const QString& file) {
  const QSettings settings(file, QSettings::IniFormat);
  const QStringList files = settings.value("recentFiles").toStringList();
  return settings.status() == QSettings::NoError && (files.isEmpty() || files.size() == kWeights) &&
         files.count(files.value(0)) == files.size() && settings.value("speed").toInt() > 0;
}

bool isWholePicture(const QString& file) {
  return contentOf(file).endsWith("</svg>\n");
}

constexpr int kKinds = 5;  // of files

/// Of each kind.
int killsWanted() {
  const int wanted = qEnvironmentVariableIntValue("ANGRYCUTS_KILLS");
  return ((wanted > 0 ? wanted : 10) + kKinds - 1) / kKinds;
}

}  // namespace

class KillTest : public QObject {
  Q_OBJECT

 private slots:
  void leavesWhatTheWindowWritesWhole_data();
  void leavesWhatTheWindowWritesWhole();
  void leavesWhatACommandWritesWhole();
  void cleanupTestCase() const;

 private:
  void killSoon(QProcess& victim, int longestDelay);

  QRandomGenerator m_random{20261122};
  int m_survived = 0;
  int m_whileWriting = 0;
};

/// @param longestDelay  [µs]
void KillTest::killSoon(QProcess& victim, int longestDelay) {
  QThread::usleep(m_random.bounded(longestDelay));
  victim.kill();
  QVERIFY(victim.waitForFinished());
}

void KillTest::leavesWhatTheWindowWritesWhole_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<IsWhole>("isWhole");
  QTest::newRow("scene") << "scene.json" << IsWhole(isWholeScene);
  QTest::newRow("draft") << "one.draft" << IsWhole(isWholeDraft);
  QTest::newRow("settings") << "angrycuts/angrycuts.conf" << IsWhole(areWholeSettings);
  QTest::newRow("picture") << "picture.svg" << IsWhole(isWholePicture);
}

void KillTest::leavesWhatTheWindowWritesWhole() {
  QFETCH(QString, name);
  QFETCH(IsWhole, isWhole);
  const QTemporaryDir folder;
  const QString file = folder.filePath(name);
  bool stands = false;
  for (int kill = 1; kill <= killsWanted(); ++kill) {
    QProcess victim;
    victim.start(QCoreApplication::applicationFilePath(), {"--victim", name, folder.path()});
    QVERIFY(victim.waitForReadyRead());  // it has begun to write
    killSoon(victim, 100'000);
    if (victim.readAll().endsWith('(')) ++m_whileWriting;
    // Only before the first time may it be missing.
    QVERIFY(QFile::exists(file) || !stands);
    stands = QFile::exists(file);
    QVERIFY2(!stands || isWhole(file), qPrintable(QString("half after kill %1").arg(kill)));
    ++m_survived;
  }
  QVERIFY(stands || killsWanted() < 10);
}

void KillTest::leavesWhatACommandWritesWhole() {
  const QTemporaryDir folder;
  const QString file = folder.filePath("rows.csv");
  const QStringList call{"simulate", "seven-weights", "--sample", "0.002", "--trajectory", file};
  QCOMPARE(QProcess::execute(ANGRYCUTS_PROGRAM, call), 0);
  const QByteArray whole = contentOf(file);
  QVERIFY(whole.size() > 1 << 20);
  for (int kill = 1; kill <= killsWanted(); ++kill) {
    QFile old(file);
    QVERIFY(old.open(QIODevice::WriteOnly));
    old.write("old");
    old.close();
    QProcess victim;
    victim.start(ANGRYCUTS_PROGRAM, call);
    QVERIFY(victim.waitForStarted());
    killSoon(victim, 80'000);
    if (contentOf(file) == "old") ++m_whileWriting;
    QVERIFY2(contentOf(file) == "old" || contentOf(file) == whole,
             qPrintable(QString("half after kill %1").arg(kill)));
    ++m_survived;
  }
}

void KillTest::cleanupTestCase() const {
  std::printf("kills survived: %d, of them %d at work on a file\n", m_survived, m_whileWriting);
}

int main(int argc, char** argv) {
  const QApplication application(argc, argv);
  const QStringList arguments = QApplication::arguments();
  if (arguments.value(1) == "--victim") {
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, arguments.value(3));
    runVictim(arguments.value(2), arguments.value(3));
  }
  KillTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "kill_test.moc"
