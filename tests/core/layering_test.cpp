#include <algorithm>
#include <array>

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTextStream>
#include <QtTest>

namespace {

// A folder of core includes only itself and folders before it.
constexpr std::array kCoreFolders{"system", "scene",     "motion", "methods", "contact",
                                  "run",    "recording", "trade",  "aim"};

// Files, random numbers and clocks: what would make core depend on more than its input.
const QStringList kForbiddenInCore{"chrono",   "ctime",      "time.h",     "sys/time.h", "random",
                                   "fstream",  "iostream",   "filesystem", "cstdio",     "stdio.h",
                                   "unistd.h", "sys/stat.h", "sys/types.h"};

const QStringList kClocks{"chrono", "ctime"};

/// The only folder that may look at a clock: it measures.
const QString kFolderWithClock = "trade";

/// The only folder that may know which system the program runs on.
const QString kSystemFolder = "system";

// What asks a system for something, or asks which one it is.
const QStringList kOfSystems{"unistd.h", "fcntl.h", "pthread.h", "dlfcn.h",  "signal.h",
                             "csignal",  "io.h",    "windows.h", "termios.h"};
const QRegularExpression kWhichSystem(R"(\b(Q_OS_\w+|_WIN32|__linux__|__APPLE__|__unix__)\b)");

qsizetype placeOf(const QString& coreFolder) {
  return std::ranges::find(kCoreFolders, coreFolder) - kCoreFolders.begin();
}

bool isOfQt(const QString& header) {
  // The standard library's <queue> has no ending, Qt's <qglobal.h> has one.
  return header.startsWith('Q') || (header.startsWith('q') && header.endsWith(".h"));
}

QString faultInCore(const QString& folder, const QString& header, bool isQuoted) {
  if (!isQuoted) {
    if (folder == kSystemFolder && !isOfQt(header)) return {};
    if (kClocks.contains(header) && folder == kFolderWithClock) return {};
    if (isOfQt(header)) return "core knows no Qt";
    if (kForbiddenInCore.contains(header)) return "core knows no files, random numbers or clocks";
    return {};
  }
  if (header.section('/', 0, 0) != "core") return "core includes only core";
  if (header.section('/', 1, 1) == kSystemFolder && folder != kSystemFolder &&
      folder != kFolderWithClock) {
    return "core depends on no system";
  }
  const qsizetype own = placeOf(folder);
  const qsizetype included = placeOf(header.section('/', 1, 1));
  const auto count = static_cast<qsizetype>(kCoreFolders.size());
  if (own == count || included == count) return "not a folder of core";
  return included > own ? "a folder of core includes only those before it" : QString();
}

bool isOfSystem(const QString& header) {
  return kOfSystems.contains(header) || header.startsWith("sys/");
}

/// What is wrong with one line of a source file; empty if it is in order.
/// @param file  path from the top of the source tree
QString faultIn(const QString& file, const QString& line) {
  const bool knowsSystems = file.startsWith("core/" + kSystemFolder + '/');
  if (!knowsSystems && line.contains(kWhichSystem)) return "only core/system asks which system";
  static const QRegularExpression kInclude(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  const QRegularExpressionMatch match = kInclude.match(line);
  if (!match.hasMatch()) return {};
  const QString header = match.captured(2);
  if (!knowsSystems && isOfSystem(header)) return "only core/system asks the system";
  const QString layer = file.section('/', 0, 0);
  if (layer == "core")
    return faultInCore(file.section('/', 1, 1), header, match.captured(1) == "\"");
  if (header.contains("..")) return "includes start at the top of the source tree";
  if (layer == "ui" && header.startsWith("app/")) return "ui does not include app";
  return {};
}

}  // namespace

class LayeringTest : public QObject {
  Q_OBJECT

 private slots:
  void noticesIncludesThatPointTheWrongWay_data();
  void noticesIncludesThatPointTheWrongWay();
  void allowsIncludesThatPointTheRightWay_data();
  void allowsIncludesThatPointTheRightWay();
  void holdsInEverySourceFile();
};

void LayeringTest::noticesIncludesThatPointTheWrongWay_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("line");
  QTest::newRow("Qt in core") << "core/run/run.cpp"
                              << "#include <QString>";
  QTest::newRow("Qt module in core") << "core/run/run.cpp"
                                     << "#include <QtGlobal>";
  QTest::newRow("Qt's own name in core") << "core/run/run.cpp"
                                         << "#include <qglobal.h>";
  QTest::newRow("Qt by folder in core") << "core/run/run.cpp"
                                        << "#include <QtCore/QString>";
  QTest::newRow("file in core") << "core/recording/csv.cpp"
                                << "#include <fstream>";
  QTest::newRow("file system in core") << "core/scene/scene.h"
                                       << "# include <filesystem>";
  QTest::newRow("random number in core") << "core/scene/arrangement.cpp"
                                         << "#include <random>";
  QTest::newRow("clock in core") << "core/run/step_clock.cpp"
                                 << "#include <chrono>";
  QTest::newRow("file in trade") << "core/trade/measurement.cpp"
                                 << "#include <fstream>";
  QTest::newRow("next folder") << "core/scene/scene.h"
                               << "#include \"core/motion/swing.h\"";
  QTest::newRow("last folder") << "core/contact/path.h"
                               << "  #include \"core/trade/reference.h\"";
  QTest::newRow("run from contact") << "core/contact/rest.cpp"
                                    << "#include \"core/run/event.h\"";
  QTest::newRow("new folder") << "core/scene/scene.h"
                              << "#include \"core/extras/more.h\"";
  QTest::newRow("from a new folder") << "core/extras/a.h"
                                     << "#include \"core/scene/scene.h\"";
  QTest::newRow("beside itself") << "core/scene/scene.cpp"
                                 << "#include \"scene.h\"";
  QTest::newRow("upwards") << "core/scene/scene.cpp"
                           << "#include \"../run/run.h\"";
  QTest::newRow("ui in core") << "core/run/run.cpp"
                              << "#include \"ui/main_window.h\"";
  QTest::newRow("app in core") << "core/run/run.cpp"
                               << "#include \"app/options.h\"";
  QTest::newRow("app in ui") << "ui/main_window.cpp"
                             << "#include \"app/options.h\"";
  QTest::newRow("app in ui, upwards") << "ui/main_window.cpp"
                                      << "#include \"../app/options.h\"";
  QTest::newRow("system in run") << "core/run/run.cpp"
                                 << "#include \"core/system/cpu_clock.h\"";
  QTest::newRow("Qt in system") << "core/system/screen.cpp"
                                << "#include <QtGlobal>";
  QTest::newRow("POSIX in ui") << "ui/files/output_file.cpp"
                               << "#include <unistd.h>";
  QTest::newRow("Linux in ui") << "ui/files/output_file.cpp"
                               << "#include <sys/stat.h>";
  QTest::newRow("signals in app") << "app/main.cpp"
                                  << "#include <csignal>";
  QTest::newRow("which system, by compiler") << "core/motion/lanes.h"
                                             << "#if defined(__linux__)";
  QTest::newRow("which system, by Qt") << "app/main.cpp"
                                       << "#ifdef Q_OS_WIN";
}

void LayeringTest::noticesIncludesThatPointTheWrongWay() {
  QFETCH(QString, file);
  QFETCH(QString, line);
  QVERIFY(!faultIn(file, line).isEmpty());
}

void LayeringTest::allowsIncludesThatPointTheRightWay_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("line");
  QTest::newRow("same folder") << "core/run/run.cpp"
                               << "#include \"core/run/event.h\"";
  QTest::newRow("folder before") << "core/run/run.cpp"
                                 << "#include \"core/scene/scene.h\"";
  QTest::newRow("standard library") << "core/run/run.cpp"
                                    << "#include <vector>";
  QTest::newRow("standard library, with q") << "core/run/run.cpp"
                                            << "#include <queue>";
  QTest::newRow("Eigen") << "core/run/run.cpp"
                         << "#include <Eigen/Core>";
  QTest::newRow("clock in trade") << "core/trade/measurement.cpp"
                                  << "#include <chrono>";
  QTest::newRow("system in trade") << "core/trade/timing.cpp"
                                   << "#include \"core/system/cpu_clock.h\"";
  QTest::newRow("POSIX in system") << "core/system/streams.cpp"
                                   << "#include <unistd.h>";
  QTest::newRow("clock in system") << "core/system/cpu_clock.cpp"
                                   << "#include <ctime>";
  QTest::newRow("which system, in system") << "core/system/streams.cpp"
                                           << "#ifdef _WIN32";
  QTest::newRow("system in app") << "app/main.cpp"
                                 << "#include \"core/system/streams.h\"";
  QTest::newRow("core in ui") << "ui/main_window.cpp"
                              << "#include \"core/run/run.h\"";
  QTest::newRow("Qt in ui") << "ui/main_window.cpp"
                            << "#include <QMainWindow>";
  QTest::newRow("ui in app") << "app/main.cpp"
                             << "#include \"ui/main_window.h\"";
  QTest::newRow("no include") << "core/run/run.cpp"
                              << "// as \"ui/main_window.h\" shows it";
}

void LayeringTest::allowsIncludesThatPointTheRightWay() {
  QFETCH(QString, file);
  QFETCH(QString, line);
  QCOMPARE(faultIn(file, line), QString());
}

void LayeringTest::holdsInEverySourceFile() {
  const QDir top(ANGRYCUTS_SOURCE_DIR);
  int lines = 0;
  for (const char* layer : {"core", "ui", "app"}) {
    QDirIterator files(top.filePath(layer), {"*.h", "*.cpp"}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
      QFile file(files.next());
      QVERIFY(file.open(QIODevice::ReadOnly));
      const QString path = top.relativeFilePath(file.fileName());
      QTextStream text(&file);
      for (QString line; text.readLineInto(&line); ++lines) {
        const QString fault = faultIn(path, line);
        QVERIFY2(fault.isEmpty(), qPrintable(path + ": " + line + ": " + fault));
      }
    }
  }
  QVERIFY2(lines > 1000, "the source tree was not found");
}

QTEST_APPLESS_MAIN(LayeringTest)
#include "layering_test.moc"
