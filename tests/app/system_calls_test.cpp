// Watches by strace what the program asks of the system: no network, no other programs, and no
// file written but those asked for and its own.

#include <cstdlib>

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "ui/control/commands.h"
#include "ui/control/draft_keeper.h"
#include "ui/control/exports.h"
#include "ui/control/first_scene.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/main_window.h"

using ui::Command;

namespace {

// Nothing may come of what a scene calls itself.
const QByteArray kScene =
    "{\"format\": \"angry-cuts/scene\", \"version\": 1, \"cutTime\": 0.2,"
    "\"name\": \"<img src='%1'> $(touch %2) `touch %2`\","
    "\"description\": \"<a href='http://example.org/'>x</a><img src='file://%1'>\","
    "\"weights\": [{\"rope\": {\"pivot\": [2, 2.5], \"angle\": 60}}]}";

// What Qt and the libraries below it open for writing, wherever the program runs: devices, and
// the cache of fonts that fontconfig keeps for all users where it may.
const QStringList kOfTheSystem{"/dev/null", "/dev/tty", "/dev/dri/", "/dev/shm/",
                               "/var/cache/fontconfig"};

void play(ui::MainWindow& window) {
  ui::RunController& controller = *window.controller();
  controller.setStopwatch([] { return 0.0; });
  controller.play();
  for (int frame = 0; frame < 30; ++frame) {
    controller.passTime(1.0 / 60);
    QCoreApplication::processEvents();
  }
  controller.pause();
}

void changeAndKeep(ui::MainWindow& window) {
  window.keepDraftsIn(ui::draftFolder());
  window.editor()->change([](core::Scene& draft) { draft.gravity = 3; });
  window.findChild<ui::DraftKeeper*>()->keepAndWait();
}

void writeEverything(ui::MainWindow& window) {
  for (const char* ending : {"png", "svg", "pdf"}) {
    window.exports()->saveChart(QString("out/chart.%1").arg(ending));
    window.exports()->savePicture(QString("out/picture.%1").arg(ending));
  }
  window.exports()->saveLedger("out/ledger.csv", 0);
  window.files()->saveTo("out/scene.json");
}

/// A short session, in a process of its own that is watched: two windows, of which the first
/// leaves a draft behind as a crash does.
int runSession(const QString& scene) {
  QTimer dialogs;  // closes them, so that the session goes on
  dialogs.callOnTimeout([] {
    if (QWidget* dialog = QApplication::activeModalWidget()) dialog->close();
  });
  dialogs.start(0);
  const ui::FirstScene first = ui::firstScene(scene);
  {
    ui::MainWindow crashed(*first.scene);
    changeAndKeep(crashed);
  }
  ui::MainWindow window(*first.scene, first.file);
  window.show();
  changeAndKeep(window);
  for (const Command command : {Command::kPresent, Command::kPresent, Command::kKeys,
                                Command::kMeasure, Command::kWhenToCut, Command::kWeightsTable}) {
    window.commands().action(command)->trigger();
    play(window);
  }
  window.files()->open("<img src='bait.png'>.json");  // is not there, which a message says
  writeEverything(window);
  return window.close() ? EXIT_SUCCESS : EXIT_FAILURE;
}

QStringList linesOf(const QString& file) {
  QFile input(file);
  if (!input.open(QIODevice::ReadOnly)) return {};
  return QString::fromUtf8(input.readAll()).split('\n', Qt::SkipEmptyParts);
}

/// The names of files that a call would make or change.
QStringList filesChangedBy(const QString& call) {
  static const QRegularExpression kOpen(R"(^\d+ +(open|openat|openat2|creat)\()");
  static const QRegularExpression kWriting("O_WRONLY|O_RDWR|O_CREAT|O_TRUNC|O_TMPFILE");
  static const QRegularExpression kChange(
      R"(^\d+ +(mkdir|rename|link|symlink|unlink|rmdir|truncate|mknod|chmod|fchmodat|chown|lchown)"
      R"(|fchownat|utime|setxattr|lsetxattr|mount|umount)\w*\()");
  static const QRegularExpression kName("\"([^\"]*)\"");
  const bool writes = call.contains(kOpen) ? call.contains(kWriting) : call.contains(kChange);
  QStringList names;
  if (!writes) return names;
  for (auto match = kName.globalMatch(call); match.hasNext();) names << match.next().captured(1);
  names.removeIf([](const QString& name) { return name.startsWith("/proc/self/fd/"); });
  return names;
}

bool isNetwork(const QString& call) {
  static const QRegularExpression kSocket(R"(^\d+ +socket(pair)?\((?!AF_UNIX))");
  static const QRegularExpression kAddress(R"(sa_family=AF_(?!UNIX))");
  return call.contains(kSocket) || call.contains(kAddress);
}

bool isSocket(const QString& call) {
  static const QRegularExpression kSocket(R"(^\d+ +(socket|connect|bind|listen)\()");
  return call.contains(kSocket);
}

/// A program or a process of its own; threads are none.
bool startsSomething(const QString& call) {
  static const QRegularExpression kExec(R"(^\d+ +(execve|execveat|fork|vfork)\()");
  static const QRegularExpression kClone(R"(^\d+ +clone3?\()");
  return call.contains(kExec) || (call.contains(kClone) && !call.contains("CLONE_THREAD"));
}

/// Touches a file that nobody but a scene's name or description speaks of.
bool takesTheBait(const QString& call) {
  static const QRegularExpression kBait("[/\"](bait\\.png|touched)\"");
  return call.contains(kBait);
}

}  // namespace

class SystemCallsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void seesWhatIsForbidden();
  void commandsWriteOnlyWhatIsAskedFor_data();
  void commandsWriteOnlyWhatIsAskedFor();
  void aSessionWritesOnlyWhatIsItsOwn();
  void theWindowOnADisplayStartsNothing();

 private:
  QString path(const QString& name) const { return m_folder->filePath(name); }
  QProcessEnvironment surroundings() const;
  QStringList callsOf(const QStringList& command, const QStringList& launcher = {}) const;
  QStringList foreignFiles(const QStringList& calls, const QStringList& own) const;
  void verifyHarmless(const QStringList& calls, const QStringList& own) const;

  std::unique_ptr<QTemporaryDir> m_folder;
};

void SystemCallsTest::initTestCase() {
  if (QStandardPaths::findExecutable("strace").isEmpty()) QSKIP("strace is not installed");
  QProcess trial;
  trial.start("strace", {"-qq", "-o", "/dev/null", "true"});
  if (!trial.waitForFinished() || trial.exitCode() != 0) QSKIP("strace may not watch here");
}

void SystemCallsTest::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  for (const char* folder : {"out", "home", "config", "data", "cache"})
    QVERIFY(QDir(m_folder->path()).mkdir(folder));
  QByteArray scene = kScene;
  scene.replace("%1", path("bait.png").toUtf8()).replace("%2", path("touched").toUtf8());
  QFile file(path("scene.json"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(scene);
}

/// A home of its own, and no bus: what a bare system has.
QProcessEnvironment SystemCallsTest::surroundings() const {
  QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
  all.remove("DBUS_SESSION_BUS_ADDRESS");
  all.insert("ASAN_OPTIONS", "detect_leaks=0");  // leaks cannot be looked for while watched
  all.insert("HOME", path("home"));
  all.insert("XDG_CONFIG_HOME", path("config"));
  all.insert("XDG_DATA_HOME", path("data"));
  all.insert("XDG_CACHE_HOME", path("cache"));
  all.insert("XDG_RUNTIME_DIR", path("runtime"));
  return all;
}

/// @param launcher  a program and its arguments that starts what is watched
/// @return          calls to do with files, processes and networks, one a line, without the
///                  first, which starts the command
QStringList SystemCallsTest::callsOf(const QStringList& command,
                                     const QStringList& launcher) const {
  QStringList all = launcher;
  all << "strace"
      << "-f"
      << "-qq"
      << "-s"
      << "4096"
      << "-e"
      << "signal=none"
      << "-e"
      << "trace=%file,%process,%network"
      << "-o" << path("calls") << command;
  QProcess process;
  process.setProcessEnvironment(surroundings());
  process.setWorkingDirectory(m_folder->path());
  process.start(all.takeFirst(), all);
  process.waitForFinished(100'000);
  if (process.exitCode() != 0) qWarning() << process.readAllStandardError();
  return linesOf(path("calls")).mid(1);
}

/// What is written to outside the folders named and the system's own places.
QStringList SystemCallsTest::foreignFiles(const QStringList& calls, const QStringList& own) const {
  QStringList foreign;
  for (const QString& call : calls) {
    for (const QString& name : filesChangedBy(call)) {
      const QString file = QDir::cleanPath(QDir(m_folder->path()).absoluteFilePath(name));
      const auto holds = [&](const QString& place) { return file.startsWith(place); };
      const auto isOwn = [&](const QString& place) { return holds(path(place)); };
      if (std::ranges::any_of(kOfTheSystem, holds) || std::ranges::any_of(own, isOwn)) continue;
      foreign << call;
    }
  }
  return foreign;
}

void SystemCallsTest::verifyHarmless(const QStringList& calls, const QStringList& own) const {
  QVERIFY(calls.size() > 100);
  QCOMPARE(foreignFiles(calls, own).join('\n'), QString());
  for (const QString& call : calls) {
    QVERIFY2(!isNetwork(call), qPrintable(call));
    QVERIFY2(!startsSomething(call), qPrintable(call));
    QVERIFY2(!takesTheBait(call), qPrintable(call));
  }
}

void SystemCallsTest::seesWhatIsForbidden() {
  const QStringList calls =
      callsOf({"bash", "-c",
               "(exec 3<>/dev/udp/127.0.0.1/9) ; touch here; mkdir made; ln -s a b; cat bait.png"});
  const auto has = [&](auto question) { return std::ranges::any_of(calls, question); };
  QVERIFY(has(isNetwork));
  QVERIFY(has(isSocket));
  QVERIFY(has(startsSomething));
  QVERIFY(has(takesTheBait));
  const QString foreign = foreignFiles(calls, {}).join('\n');
  for (const char* name : {"here", "made", "\"b\""}) QVERIFY2(foreign.contains(name), name);
  QVERIFY(foreignFiles(calls, {"here", "made", "a", "b"}).isEmpty());
}

void SystemCallsTest::commandsWriteOnlyWhatIsAskedFor_data() {
  QTest::addColumn<QStringList>("call");
  const auto row = [](const char* call) { QTest::newRow(call) << QString(call).split(' '); };
  row("simulate scene.json");
  row("simulate scene.json --trajectory out/t.csv --energy out/e.csv --events -");
  row("simulate scene.json --chart out/chart.png");
  row("measure scene.json --until 0.1 --csv out/m.csv --chart out/m.svg");
  row("scenes --export out");
}

void SystemCallsTest::commandsWriteOnlyWhatIsAskedFor() {
  QFETCH(QStringList, call);
  const bool draws = call.contains("--chart");
  const QStringList calls = callsOf(QStringList{ANGRYCUTS_PROGRAM} + call);
  // Fonts are remembered by fontconfig, and Qt sees to a folder for what runs.
  verifyHarmless(calls,
                 draws ? QStringList{"out", "cache/fontconfig", "runtime"} : QStringList{"out"});
  for (const QString& line : calls) QVERIFY2(!isSocket(line), qPrintable(line));
}

void SystemCallsTest::aSessionWritesOnlyWhatIsItsOwn() {
  const QStringList calls =
      callsOf({QCoreApplication::applicationFilePath(), "--watched", "scene.json"});
  verifyHarmless(calls,
                 {"out", "runtime", "config/angrycuts", "data/angrycuts", "cache/fontconfig"});
  QCOMPARE(QDir(path("out")).entryList(QDir::Files).size(), 8);
  QCOMPARE(QDir(path("data/angrycuts/drafts")).entryList(QDir::Files).size(), 1);
}

void SystemCallsTest::theWindowOnADisplayStartsNothing() {
  if (QStandardPaths::findExecutable("xvfb-run").isEmpty()) QSKIP("xvfb is not installed");
  // Ends the program once it has been on the display for a while.
  const QString launch =
      "\"$@\" & watcher=$!\n"
      "for ((i = 0; i < 600; ++i)); do\n"
      "  if [ -e config/angrycuts/angrycuts.conf ]; then break; fi\n"
      "  sleep 0.1\n"
      "done\n"
      "sleep 1\n"
      "read -r program </proc/$watcher/task/$watcher/children\n"
      "kill -KILL $program\n"
      "wait\n";
  const QStringList calls = callsOf({"env", "QT_QPA_PLATFORM=xcb", ANGRYCUTS_PROGRAM, "scene.json"},
                                    {"xvfb-run", "-a", "bash", "-c", launch, "bash"});
  QVERIFY(QFile::exists(path("config/angrycuts/angrycuts.conf")));
  // The environment's own tool was started first; from there on it is the program.
  const auto isProgram = [](const QString& call) { return call.contains(ANGRYCUTS_PROGRAM); };
  const auto start = std::ranges::find_if(calls, isProgram);
  QVERIFY(start != calls.end());
  verifyHarmless(calls.mid(start - calls.begin() + 1),
                 {"config/angrycuts", "data/angrycuts", "cache/", "runtime"});
}

int main(int argc, char** argv) {
  const QApplication application(argc, argv);
  const QStringList arguments = QApplication::arguments();
  if (arguments.value(1) == "--watched") return runSession(arguments.value(2));
  SystemCallsTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "system_calls_test.moc"
