// What the window does where disks are full, folders cannot be written to, and files are not
// what they should be. Nothing here depends on permissions: root has them all.

#include <algorithm>
#include <functional>
#include <sys/stat.h>

#include <QApplication>
#include <QLocale>
#include <QMessageBox>
#include <QProgressDialog>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QSettings>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include "core/scene/arrangement.h"
#include "tests/app/faulty_surroundings.h"
#include "tests/support/small_disk.h"
#include "ui/control/draft_keeper.h"
#include "ui/control/exports.h"
#include "ui/control/first_scene.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/control/settings.h"
#include "ui/files/draft_file.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"
#include "ui/panels/message_bar.h"

using ui::DraftKeeper;
using ui::MainWindow;

namespace {

void setGravity(MainWindow& window, double gravity) {
  window.editor()->change([=](core::Scene& draft) { draft.gravity = gravity; });
}

/// Something the window writes, by the ending of its file.
using Writing = std::function<void(MainWindow&, const QString&)>;

void addWritings() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<Writing>("writeTo");
  QTest::addColumn<QString>("words");
  const QString exported = "%1 was not written:\n";
  const auto row = [](const char* what, const char* name, const Writing& writing,
                      const QString& words) {
    QTest::newRow(what) << QString(name) << writing << words;
  };
  row(
      "scene", "scene.json",
      [](MainWindow& window, const QString& file) { window.files()->saveTo(file); },
      "%1 was not saved:\n");
  for (const char* name : {"chart.png", "chart.svg", "chart.pdf"}) {
    row(
        name, name,
        [](MainWindow& window, const QString& file) { window.exports()->saveChart(file); },
        exported);
  }
  for (const char* name : {"picture.png", "picture.svg", "picture.pdf"}) {
    row(
        name, name,
        [](MainWindow& window, const QString& file) { window.exports()->savePicture(file); },
        exported);
  }
  row(
      "ledger", "ledger.csv",
      [](MainWindow& window, const QString& file) { window.exports()->saveLedger(file, 0); },
      exported);
}

ui::MessageBar* offer(const MainWindow& window) {
  for (ui::MessageBar* bar : window.findChildren<ui::MessageBar*>())
    if (bar->findChildren<QToolButton*>().first()->text() == "Bring them back") return bar;
  qFatal("no bar");
}

bool isOffered(const MainWindow& window) {
  return offer(window)->isVisibleTo(&window);
}

}  // namespace

class WindowFaultsTest : public QObject {
  Q_OBJECT

 private slots:
  void init();

  void saysThatTheDiskIsFull_data() { addWritings(); }
  void saysThatTheDiskIsFull();
  void saysThatAFolderIsReadOnly_data() { addWritings(); }
  void saysThatAFolderIsReadOnly();
  void saysThatADeviceIsFull();
  void savesAFileAgainThatWasRemovedWhileOpen();
  void saysThatTheFolderWasRemovedWhileOpen();
  void savesThroughLinks_data();
  void savesThroughLinks();

  void keepsTheOldDraftOnAFullDisk();
  void recoversOnAFullDisk();
  void leavesAHalfDraftAlone();

 private:
  QString path(const QString& name) const { return m_folder->filePath(name); }
  QString saved(const QString& name) const;

  std::unique_ptr<QTemporaryDir> m_folder;
};

void WindowFaultsTest::init() {
  QLocale::setDefault(QLocale::c());
  m_folder = std::make_unique<QTemporaryDir>();
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, path("config"));
}

QString WindowFaultsTest::saved(const QString& name) const {
  const QString error = ui::writeSceneFile(path(name), threeWeights());
  if (!error.isEmpty()) qFatal("not written");
  return path(name);
}

void WindowFaultsTest::saysThatTheDiskIsFull() {
  QFETCH(QString, name);
  QFETCH(Writing, writeTo);
  QFETCH(QString, words);
  write(path(name), "old");
  MainWindow window(threeWeights());
  setGravity(window, 3);
  const QStringList before = QDir(m_folder->path()).entryList(QDir::Files);
  const Messages messages;
  {
    const SmallDisk disk(64);
    writeTo(window, path(name));
  }
  QCOMPARE(messages.texts, QStringList(words.arg(name) + "File too large"));
  QCOMPARE(contentOf(path(name)), QByteArray("old"));
  QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files), before);
  QVERIFY(window.isWindowModified());
  verifyAlive(window);
  writeTo(window, path(name));  // there is room again
  QCOMPARE(messages.texts.size(), 1);
  QVERIFY(contentOf(path(name)) != "old");
}

void WindowFaultsTest::saysThatAFolderIsReadOnly() {
  QFETCH(QString, name);
  QFETCH(Writing, writeTo);
  QFETCH(QString, words);
  MainWindow window(threeWeights());
  setGravity(window, 3);
  const Messages messages;
  writeTo(window, kReadOnlyFolder + '/' + name);
  QCOMPARE(messages.texts.size(), 1);
  const QString reason = messages.texts.first().mid(words.arg(name).size());
  QVERIFY2(QRegularExpression(kReadOnlyWords).match(reason).hasMatch(), qPrintable(reason));
  QVERIFY(messages.texts.first().startsWith(words.arg(name)));
  QVERIFY(window.isWindowModified());
  QCOMPARE(window.files()->file(), QString());
  verifyAlive(window);
}

void WindowFaultsTest::saysThatADeviceIsFull() {
  MainWindow window(threeWeights());
  const Messages messages;
  QVERIFY(!window.files()->saveTo("/dev/full"));
  QCOMPARE(messages.texts, QStringList("full was not saved:\nNo space left on device"));
}

void WindowFaultsTest::savesAFileAgainThatWasRemovedWhileOpen() {
  const QString file = saved("three.json");
  MainWindow window(threeWeights(), file);
  QVERIFY(QFile::remove(file));
  setGravity(window, 3);
  QVERIFY(window.files()->save());
  QCOMPARE(ui::readSceneFile(file).scene->gravity, 3.0);
}

void WindowFaultsTest::saysThatTheFolderWasRemovedWhileOpen() {
  QVERIFY(QDir(m_folder->path()).mkdir("lesson"));
  const QString file = saved("lesson/three.json");
  MainWindow window(threeWeights(), file);
  QVERIFY(QDir(path("lesson")).removeRecursively());
  setGravity(window, 3);
  const Messages messages;
  QVERIFY(!window.files()->save());
  QCOMPARE(messages.texts, QStringList("three.json was not saved:\nNo such file or directory"));
  QVERIFY(window.isWindowModified());
  QVERIFY(window.files()->saveTo(path("elsewhere.json")));
  QVERIFY(!window.isWindowModified());
}

void WindowFaultsTest::savesThroughLinks_data() {
  QTest::addColumn<QString>("target");
  QTest::newRow("in the same folder") << "target.json";
  QTest::newRow("in another folder") << "other/target.json";
  QTest::newRow("through another link") << "second.json";
}

void WindowFaultsTest::savesThroughLinks() {
  QFETCH(QString, target);
  QVERIFY(QDir(m_folder->path()).mkdir("other"));
  saved("target.json");
  saved("other/target.json");
  QVERIFY(QFile::link("target.json", path("second.json")));
  QVERIFY(QFile::link(target, path("link.json")));

  MainWindow window(threeWeights());
  window.files()->open(path("link.json"));
  QCOMPARE(window.files()->file(), path("link.json"));
  setGravity(window, 3);
  QVERIFY(window.files()->save());
  QVERIFY(QFileInfo(path("link.json")).isSymbolicLink());
  QVERIFY(QFileInfo(path("second.json")).isSymbolicLink());
  QCOMPARE(ui::readSceneFile(path(target)).scene->gravity, 3.0);
}

void WindowFaultsTest::keepsTheOldDraftOnAFullDisk() {
  MainWindow window(threeWeights());
  window.keepDraftsIn(path("drafts"));
  auto* keeper = window.findChild<DraftKeeper*>();
  setGravity(window, 1);
  QVERIFY(keeper->keepAndWait());
  setGravity(window, 2);
  {
    const SmallDisk disk(64);
    QVERIFY(!keeper->keepAndWait());
  }
  QCOMPARE(window.statusBar()->currentMessage(),
           QString("Unsaved changes cannot be kept for a crash: File too large"));
  QCOMPARE(ui::readDraftFile(keeper->file())->scene.gravity, 1.0);
  QVERIFY(keeper->keepAndWait());
  QCOMPARE(ui::readDraftFile(keeper->file())->scene.gravity, 2.0);
}

void WindowFaultsTest::recoversOnAFullDisk() {
  {
    MainWindow crashed(threeWeights());
    crashed.keepDraftsIn(path("drafts"));
    setGravity(crashed, 1.5);
    QVERIFY(crashed.findChild<DraftKeeper*>()->keepAndWait());
  }
  {
    MainWindow window(threeWeights());
    window.keepDraftsIn(path("drafts"));
    QVERIFY(isOffered(window));
    const SmallDisk disk(64);
    offer(window)->findChildren<QToolButton*>().first()->click();
    QCOMPARE(window.editor()->scene()->gravity, 1.5);
    QVERIFY(window.statusBar()->currentMessage().startsWith("Unsaved changes cannot be kept"));
  }
  // What could not be kept anew is still kept where it was.
  MainWindow next(threeWeights());
  next.keepDraftsIn(path("drafts"));
  QVERIFY(isOffered(next));
}

void WindowFaultsTest::leavesAHalfDraftAlone() {
  const QString whole = path("whole");
  QCOMPARE(ui::writeDraftFile(whole, {"", threeWeights(), std::nullopt}), QString());
  const QByteArray bytes = contentOf(whole);
  QVERIFY(QDir(m_folder->path()).mkdir("drafts"));
  for (const double share : {0.0, 0.01, 0.3, 0.7, 0.999}) {
    const auto size = static_cast<qsizetype>(share * static_cast<double>(bytes.size()));
    write(path("drafts/half.draft"), bytes.left(size));
    MainWindow window(threeWeights());
    window.keepDraftsIn(path("drafts"));
    QVERIFY(!isOffered(window));
    QCOMPARE(contentOf(path("drafts/half.draft")).size(), size);
  }
}

QTEST_MAIN(WindowFaultsTest)
#include "window_faults_test.moc"
