#include <cstdio>

#include <QApplication>
#include <QDir>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include "core/scene/arrangement.h"
#include "core/scene/scene_limits.h"
#include "ui/control/draft_keeper.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/files/draft_file.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"
#include "ui/panels/message_bar.h"

using ui::DraftKeeper;
using ui::MainWindow;

namespace {

core::Scene threeWeights() {
  core::Scene scene = core::withWeightCount(core::Scene(), 3);
  scene.name = "Three";
  scene.solvers = {{.method = "rk4"}};
  return scene;
}

void setGravity(MainWindow& window, double gravity) {
  window.editor()->change([=](core::Scene& draft) { draft.gravity = gravity; });
}

/// A room this narrow is too small for the weights.
void setNarrow(MainWindow& window) {
  window.editor()->change([](core::Scene& draft) { draft.room.width = 0.5; });
}

ui::MessageBar* offer(const MainWindow& window) {
  for (ui::MessageBar* bar : window.findChildren<ui::MessageBar*>())
    if (bar->findChildren<QToolButton*>().first()->text() == "Bring them back") return bar;
  qFatal("no bar");
}

void press(const MainWindow& window, const QString& words) {
  for (QToolButton* button : offer(window)->findChildren<QToolButton*>())
    if (button->text() == words) button->click();
}

bool isOffered(const MainWindow& window) {
  return offer(window)->isVisibleTo(&window);
}

/// Lets the keeper's time be up.
void keepNow(const MainWindow& window) {
  QVERIFY(window.findChild<DraftKeeper*>()->keepAndWait());
}

/// What runs in a process of its own, to be killed: changes a scene, keeps it, and waits.
int runVictim(const QString& folder) {
  MainWindow window(threeWeights());
  window.keepDraftsIn(folder);
  setGravity(window, 1.25);
  setNarrow(window);
  keepNow(window);
  std::puts("kept");
  std::fflush(stdout);
  return QApplication::exec();
}

}  // namespace

class RecoveryWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void bringsBackWhatAKilledProcessWasEditing();
  void writesWithinTenSecondsOfAChange();
  void writesByTheTimer();
  void writesNothingWhereNothingChanged();
  void keepsNothingOnceSavedOrUndone();
  void keepsNothingAfterACleanExit();
  void offersAgainWhatWasIgnored();
  void discardsWhatIsNotWanted();
  void offersSeveralOneAfterTheOther();
  void leavesTheDraftsOfRunningWindowsAlone();
  void offersDraftsWhoseLockTellsNothing_data();
  void offersDraftsWhoseLockTellsNothing();
  void bringsBackADraftThatCannotRun_data();
  void bringsBackADraftThatCannotRun();
  void bringsBackTheFileAndMayBeUndone();
  void leavesFilesThatAreNoDrafts();
  void goesOnWhereNothingCanBeWritten();

 private:
  QString folder() const { return m_folder->filePath("data/drafts"); }
  QStringList drafts() const { return QDir(folder()).entryList({"*.draft"}, QDir::Files); }
  void leaveDraft(double gravity) const;

  std::unique_ptr<QTemporaryDir> m_folder;
};

void RecoveryWindowTest::init() {
  QLocale::setDefault(QLocale::c());
  m_folder = std::make_unique<QTemporaryDir>();
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder->path());
}

/// As a crash does: the window goes without being closed.
void RecoveryWindowTest::leaveDraft(double gravity) const {
  MainWindow window(threeWeights());
  window.keepDraftsIn(folder());
  setGravity(window, gravity);
  keepNow(window);
}

void RecoveryWindowTest::bringsBackWhatAKilledProcessWasEditing() {
  QProcess victim;
  victim.start(QCoreApplication::applicationFilePath(), {"--victim", folder(), m_folder->path()});
  QVERIFY(victim.waitForReadyRead());
  QCOMPARE(victim.readLine().trimmed(), QByteArray("kept"));
  QVERIFY(QFile::exists(DraftKeeper::lockOf(QDir(folder()).filePath(drafts().first()))));
  {
    MainWindow window(threeWeights());
    window.keepDraftsIn(folder());
    QVERIFY(!isOffered(window));  // it is still at work
  }
  victim.kill();
  QVERIFY(victim.waitForFinished());
  QCOMPARE(victim.exitStatus(), QProcess::CrashExit);

  MainWindow window(threeWeights());
  window.keepDraftsIn(folder());
  QVERIFY(isOffered(window));
  QVERIFY2(offer(window)->message().contains("changes of Three"),
           qPrintable(offer(window)->message()));
  press(window, "Bring them back");
  QVERIFY(!isOffered(window));
  QCOMPARE(window.editor()->scene()->gravity, 1.25);
  QCOMPARE(window.editor()->draft().room.width, 0.5);
  QVERIFY(!window.editor()->problems().empty());
  QVERIFY(window.isWindowModified());
  QCOMPARE(drafts().size(), 1);  // in this window's care now
}

void RecoveryWindowTest::writesWithinTenSecondsOfAChange() {
  MainWindow window(threeWeights());
  window.keepDraftsIn(folder());
  const auto* timer = window.findChild<DraftKeeper*>()->findChild<QTimer*>();
  QVERIFY(!timer->isActive());
  setGravity(window, 1);
  QVERIFY(timer->isActive());
  QVERIFY(timer->isSingleShot());
  // Five seconds are left for a slow disk.
  QVERIFY(timer->interval() <= 5000);
  const int left = timer->remainingTime();
  setGravity(window, 2);
  QVERIFY(timer->remainingTime() <= left);  // not put off
}

void RecoveryWindowTest::writesByTheTimer() {
  ui::SceneEditor editor(threeWeights());
  const DraftKeeper keeper(&editor, folder(), std::chrono::milliseconds(0));
  editor.change([](core::Scene& draft) { draft.gravity = 1; });
  QTRY_COMPARE(drafts().size(), 1);
  editor.change([](core::Scene& draft) { draft.gravity = 2; });
  QTRY_COMPARE(ui::readDraftFile(keeper.file())->scene.gravity, 2.0);
  editor.undo();
  editor.undo();
  QTRY_COMPARE(drafts().size(), 0);
}

void RecoveryWindowTest::writesNothingWhereNothingChanged() {
  ui::SceneEditor editor(threeWeights());
  DraftKeeper keeper(&editor, folder());
  QVERIFY(!keeper.keepAndWait());
  QVERIFY(!QDir(folder()).exists());
  editor.change([](core::Scene& draft) { draft.gravity = 1; });
  QVERIFY(keeper.keepAndWait());
  QVERIFY(QFile::remove(keeper.file()));
  keeper.keepNow();  // would write it again were there something new
  QTest::qWait(0);
  QCOMPARE(drafts().size(), 0);
}

void RecoveryWindowTest::keepsNothingOnceSavedOrUndone() {
  MainWindow window(threeWeights());
  window.keepDraftsIn(folder());
  setGravity(window, 1);
  keepNow(window);
  QCOMPARE(drafts().size(), 1);
  QVERIFY(window.files()->saveTo(m_folder->filePath("saved.json")));
  QCOMPARE(drafts().size(), 0);
  setGravity(window, 2);
  keepNow(window);
  window.editor()->undo();
  QCOMPARE(drafts().size(), 0);
  QVERIFY(!window.findChild<DraftKeeper*>()->findChild<QTimer*>()->isActive());
}

void RecoveryWindowTest::keepsNothingAfterACleanExit() {
  MainWindow window(threeWeights());
  window.keepDraftsIn(folder());
  window.show();
  setGravity(window, 1);
  keepNow(window);
  QTimer::singleShot(0, this, [] {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    QVERIFY(question);
    question->button(QMessageBox::Discard)->click();
  });
  QVERIFY(window.close());
  QCOMPARE(QDir(folder()).entryList(QDir::Files), QStringList());
}

void RecoveryWindowTest::offersAgainWhatWasIgnored() {
  leaveDraft(1.5);
  for (int start = 0; start < 2; ++start) {
    MainWindow window(threeWeights());
    window.keepDraftsIn(folder());
    QVERIFY(isOffered(window));
    window.show();
    QVERIFY(window.close());
    QCOMPARE(drafts().size(), 1);
  }
}

void RecoveryWindowTest::discardsWhatIsNotWanted() {
  leaveDraft(1.5);
  MainWindow window(threeWeights());
  window.keepDraftsIn(folder());
  press(window, "Discard");
  QVERIFY(!isOffered(window));
  QCOMPARE(window.editor()->scene()->gravity, 9.81);
  QCOMPARE(QDir(folder()).entryList(QDir::Files), QStringList());
}

void RecoveryWindowTest::offersSeveralOneAfterTheOther() {
  leaveDraft(1.5);
  leaveDraft(2.5);
  QCOMPARE(drafts().size(), 2);
  MainWindow window(threeWeights());
  window.keepDraftsIn(folder());
  press(window, "Discard");
  QVERIFY(isOffered(window));
  press(window, "Bring them back");
  QVERIFY(!isOffered(window));
  QVERIFY(window.editor()->scene()->gravity < 3);
}

void RecoveryWindowTest::leavesTheDraftsOfRunningWindowsAlone() {
  MainWindow other(threeWeights());
  other.keepDraftsIn(folder());
  setGravity(other, 1.5);
  keepNow(other);
  MainWindow window(threeWeights());
  window.keepDraftsIn(folder());
  QVERIFY(!isOffered(window));
  setGravity(window, 2.5);
  keepNow(window);
  QCOMPARE(drafts().size(), 2);
  QCOMPARE(ui::readDraftFile(other.findChild<DraftKeeper*>()->file())->scene.gravity, 1.5);
}

void RecoveryWindowTest::offersDraftsWhoseLockTellsNothing_data() {
  QTest::addColumn<QByteArray>("lock");
  QTest::newRow("killed before it could say who it is") << QByteArray();
  QTest::newRow("this computer had another name")
      << QByteArray("1\nangrycuts\nelsewhere\nid\nid\n");
}

void RecoveryWindowTest::offersDraftsWhoseLockTellsNothing() {
  QFETCH(QByteArray, lock);
  leaveDraft(1.5);
  QFile file(DraftKeeper::lockOf(QDir(folder()).filePath(drafts().first())));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(lock);
  file.close();
  MainWindow window(threeWeights());
  window.keepDraftsIn(folder());
  QVERIFY(isOffered(window));
}

void RecoveryWindowTest::bringsBackADraftThatCannotRun_data() {
  using Edit = ui::SceneEditor::Edit;
  QTest::addColumn<Edit>("edit");
  QTest::newRow("narrow room") << Edit([](core::Scene& draft) { draft.room.width = 0.5; });
  QTest::newRow("negative mass") << Edit([](core::Scene& draft) { draft.weights[1].mass = -1; });
  QTest::newRow("angle too large") << Edit([](core::Scene& draft) {
    draft.weights[1].rope->angle = 10;
    draft.weights[2].rope->angularVelocity = 1e7;
  });
  QTest::newRow("overlap") << Edit(
      [](core::Scene& draft) { draft.weights.push_back(draft.weights.front()); });
  QTest::newRow("step") << Edit([](core::Scene& draft) { draft.solvers[0].step = 100; });
  QTest::newRow("too many weights") << Edit(
      [](core::Scene& draft) { draft.weights.resize(core::kMostWeights + 1, draft.weights[0]); });
}

void RecoveryWindowTest::bringsBackADraftThatCannotRun() {
  QFETCH(ui::SceneEditor::Edit, edit);
  const QString file = m_folder->filePath("one.draft");
  ui::SceneEditor editor(threeWeights());
  QVERIFY(!editor.change(edit));
  QCOMPARE(ui::writeDraftFile(file, {"a.json", *editor.scene(), editor.draft()}), QString());
  const auto kept = ui::readDraftFile(file);
  QVERIFY(kept.has_value());
  QCOMPARE(kept->file, QString("a.json"));
  QVERIFY(kept->scene == *editor.scene());
  QVERIFY(kept->draft == editor.draft());
}

void RecoveryWindowTest::bringsBackTheFileAndMayBeUndone() {
  const QString file = m_folder->filePath("three.json");
  QCOMPARE(ui::writeSceneFile(file, threeWeights()), QString());
  {
    MainWindow window(threeWeights(), file);
    window.keepDraftsIn(folder());
    setGravity(window, 1.5);
    keepNow(window);
  }
  MainWindow window(core::withWeightCount(threeWeights(), 1));
  window.keepDraftsIn(folder());
  QVERIFY(offer(window)->message().contains("changes of three.json"));
  press(window, "Bring them back");
  QCOMPARE(window.files()->file(), file);
  QVERIFY(window.files()->save());
  QCOMPARE(ui::readSceneFile(file).scene->gravity, 1.5);
  QCOMPARE(drafts().size(), 0);
  window.editor()->undo();
  QCOMPARE(window.editor()->scene()->weights.size(), std::size_t{1});
}

void RecoveryWindowTest::leavesFilesThatAreNoDrafts() {
  QVERIFY(QDir().mkpath(folder()));
  QFile file(QDir(folder()).filePath("other.draft"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write("something else");
  file.close();
  MainWindow window(threeWeights());
  window.keepDraftsIn(folder());
  QVERIFY(!isOffered(window));
  QCOMPARE(QDir(folder()).entryList(QDir::Files), QStringList("other.draft"));
}

void RecoveryWindowTest::goesOnWhereNothingCanBeWritten() {
  QFile inTheWay(m_folder->filePath("data"));
  QVERIFY(inTheWay.open(QIODevice::WriteOnly));
  MainWindow window(threeWeights());
  window.keepDraftsIn(folder());
  setGravity(window, 1);
  QVERIFY(!window.findChild<DraftKeeper*>()->keepAndWait());
  QVERIFY2(window.statusBar()->currentMessage().startsWith("Unsaved changes cannot be kept"),
           qPrintable(window.statusBar()->currentMessage()));
  window.statusBar()->clearMessage();
  setGravity(window, 2);
  QVERIFY(!window.findChild<DraftKeeper*>()->keepAndWait());
  QCOMPARE(window.statusBar()->currentMessage(), QString());  // said once
  QCOMPARE(window.editor()->scene()->gravity, 2.0);
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  const QStringList arguments = QApplication::arguments();
  if (arguments.value(1) == "--victim") {
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, arguments.value(3));
    return runVictim(arguments.value(2));
  }
  RecoveryWindowTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "recovery_window_test.moc"
