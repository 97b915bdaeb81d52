#include <functional>

#include <QAction>
#include <QApplication>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QUrl>

#include "core/scene/arrangement.h"
#include "tests/support/shown_window.h"
#include "ui/control/commands.h"
#include "ui/control/first_scene.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/control/settings.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"
#include "ui/panels/charts_panel.h"
#include "ui/panels/quantity_field.h"

using tests::showInFront;
using ui::Command;
using ui::MainWindow;

namespace {

core::Scene sceneOf(int weights) {
  core::Scene scene = core::withWeightCount(core::Scene(), weights);
  scene.solvers = {{.method = "rk4"}};
  return scene;
}

std::size_t weightsIn(const MainWindow& window) {
  return window.controller()->scene().weights.size();
}

void modify(MainWindow& window) {
  window.editor()->change([](core::Scene& draft) { draft.gravity = 3; });
  QVERIFY(window.isWindowModified());
}

QMenu* menuNamed(const MainWindow& window, const QString& title) {
  for (QMenu* menu : window.findChildren<QMenu*>())
    if (menu->title() == title) return menu;
  qFatal("no menu %s", qPrintable(title));
}

/// What the menu of recent files offers now.
QList<QAction*> recent(const MainWindow& window) {
  QMenu* menu = menuNamed(window, "Open &recent");
  emit menu->aboutToShow();
  return menu->actions();
}

QStringList recentNames(const MainWindow& window) {
  QStringList names;
  for (const QAction* action : recent(window))
    if (!action->isSeparator()) names << action->text();
  return names;
}

/// Answers the messages that are about to appear, one after the other, and notes what they say.
class Answers {
 public:
  explicit Answers(QList<QMessageBox::StandardButton> buttons) : m_buttons(std::move(buttons)) {
    m_timer.callOnTimeout([this] { answer(); });
    m_timer.start(0);
  }

  QStringList texts;

 private:
  void answer() {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!box || !box->isVisible() || m_buttons.isEmpty()) return;
    texts << box->text();
    box->button(m_buttons.takeFirst())->click();
  }

  QList<QMessageBox::StandardButton> m_buttons;
  QTimer m_timer;
};

/// Drops files onto a widget, as a file manager does.
bool drop(QWidget* target, const QList<QUrl>& urls) {
  QMimeData data;
  data.setUrls(urls);
  QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  enter.ignore();
  QApplication::sendEvent(target, &enter);
  if (!enter.isAccepted()) return false;
  QDropEvent event({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(target, &event);
  QCoreApplication::processEvents();
  return true;
}

}  // namespace

class FilesWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void init();
  void everyWayOfLeavingAsksFirst_data();
  void everyWayOfLeavingAsksFirst();
  void tellsWhatIsNotSavedOfADraft();
  void listsTheFilesOpenedAndSavedLast();
  void keepsTenRecentFiles();
  void saysThatARecentFileIsGone();
  void clearsTheListOfRecentFiles();
  void opensASceneDroppedAnywhere();
  void saysWhyADropIsNoScene_data();
  void saysWhyADropIsNoScene();
  void leavesDroppedTextToTheFields();
  void startsWithTheSceneOfLastTime();
  void startsWithTheBuiltInSceneOfLastTime();
  void startsWithTheDemonstrationWhereTheLastSceneIsGone();
  void theCommandLineWins();
  void comesBackAsItWasLeft();

 private:
  QString saved(const QString& name, int weights) const;

  std::unique_ptr<QTemporaryDir> m_folder;
};

void FilesWindowTest::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder->path());
}

QString FilesWindowTest::saved(const QString& name, int weights) const {
  const QString file = m_folder->filePath(name);
  if (!ui::writeSceneFile(file, sceneOf(weights)).isEmpty()) qFatal("not written");
  return file;
}

void FilesWindowTest::everyWayOfLeavingAsksFirst_data() {
  using Way = std::function<void(MainWindow&, const QString&)>;
  QTest::addColumn<Way>("leave");
  const auto press = [](Qt::Key key) {
    return Way([key](MainWindow& window, const QString&) {
      QTest::keyClick(&window, key, Qt::ControlModifier);
    });
  };
  QTest::newRow("quit") << press(Qt::Key_Q);
  QTest::newRow("new") << press(Qt::Key_N);
  QTest::newRow("open") << press(Qt::Key_O);
  QTest::newRow("built in") << Way([](MainWindow& window, const QString&) {
    QMenu* menu = menuNamed(window, "&Built-in scenes");
    emit menu->aboutToShow();
    menu->actions().first()->trigger();
  });
  QTest::newRow("recent") << Way(
      [](MainWindow& window, const QString&) { recent(window).first()->trigger(); });
  QTest::newRow("drop") << Way(
      [](MainWindow& window, const QString& file) { drop(&window, {QUrl::fromLocalFile(file)}); });
}

void FilesWindowTest::everyWayOfLeavingAsksFirst() {
  QFETCH(std::function<void(MainWindow&, const QString&)>, leave);
  const QString file = saved("two.json", 2);
  MainWindow window(sceneOf(3), file);
  showInFront(window);
  modify(window);
  const Answers answers({QMessageBox::Cancel});
  leave(window, file);
  QCOMPARE(answers.texts.size(), 1);
  QVERIFY(answers.texts.first().contains("not saved"));
  QVERIFY(window.isVisible());
  QCOMPARE(weightsIn(window), std::size_t{3});
  QCOMPARE(window.controller()->scene().gravity, 3.0);
  window.editor()->setSaved();
}

void FilesWindowTest::tellsWhatIsNotSavedOfADraft() {
  MainWindow window(sceneOf(3), saved("three.json", 3));
  showInFront(window);
  window.editor()->change([](core::Scene& draft) { draft.room.width = 0.5; });
  QString told;
  QTimer::singleShot(0, this, [&] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    QVERIFY(box);
    told = box->informativeText();
    box->button(QMessageBox::Cancel)->click();
  });
  window.close();
  QVERIFY2(told.startsWith("What could not be applied is not saved: "), qPrintable(told));
  QVERIFY(window.isVisible());
  window.editor()->giveUpDraft();
}

void FilesWindowTest::listsTheFilesOpenedAndSavedLast() {
  const QString three = saved("three.json", 3);
  const QString two = saved("two & more.json", 2);
  MainWindow window(sceneOf(3), three);
  window.files()->open(two);
  QCOMPARE(recentNames(window),
           QStringList({"&1  two && more.json", "&2  three.json", "&Clear this list"}));
  QVERIFY(window.files()->saveTo(m_folder->filePath("new.json")));
  QCOMPARE(recentNames(window).first(), QString("&1  new.json"));
  recent(window).at(2)->trigger();
  QCOMPARE(weightsIn(window), std::size_t{3});
  QCOMPARE(recentNames(window).first(), QString("&1  three.json"));
  QCOMPARE(recentNames(window).size(), 4);
  QCOMPARE(recent(window).first()->statusTip(), three);
}

void FilesWindowTest::keepsTenRecentFiles() {
  MainWindow window(sceneOf(3));
  for (int i = 1; i <= 12; ++i) window.files()->open(saved(QString("%1.json").arg(i), 1));
  const QStringList names = recentNames(window);
  QCOMPARE(names.size(), 11);
  QCOMPARE(names.at(0), QString("&1  12.json"));
  QCOMPARE(names.at(9), QString("1&0  3.json"));
}

void FilesWindowTest::saysThatARecentFileIsGone() {
  const QString two = saved("two.json", 2);
  MainWindow window(sceneOf(3));
  window.files()->open(two);
  QVERIFY(QFile::remove(two));
  QCOMPARE(recentNames(window).first(), QString("&1  two.json (gone)"));
  const Answers answers({QMessageBox::Ok});
  recent(window).first()->trigger();
  QCOMPARE(answers.texts.size(), 1);
  QVERIFY(answers.texts.first().contains("no longer there"));
  QCOMPARE(recentNames(window), QStringList("&Clear this list"));
}

void FilesWindowTest::clearsTheListOfRecentFiles() {
  MainWindow window(sceneOf(3), saved("three.json", 3));
  recent(window).last()->trigger();
  QCOMPARE(recentNames(window), QStringList("&Clear this list"));
  QVERIFY(!recent(window).last()->isEnabled());
}

void FilesWindowTest::opensASceneDroppedAnywhere() {
  MainWindow window(sceneOf(3));
  showInFront(window);
  QVERIFY(drop(&window, {QUrl::fromLocalFile(saved("two.json", 2))}));
  QCOMPARE(weightsIn(window), std::size_t{2});
  auto* field = window.findChild<ui::QuantityField*>()->spinBox();
  QVERIFY(drop(field, {QUrl::fromLocalFile(saved("one.json", 1))}));
  QCOMPARE(weightsIn(window), std::size_t{1});
  QVERIFY(!field->text().contains("file"));
}

void FilesWindowTest::saysWhyADropIsNoScene_data() {
  QTest::addColumn<QStringList>("names");
  QTest::addColumn<QString>("reason");
  QTest::newRow("two files") << QStringList({"a.json", "b.json"}) << "These are 2 files";
  QTest::newRow("a folder") << QStringList({"."}) << "It is a folder";
  QTest::newRow("not a scene") << QStringList({"note.txt"}) << "not JSON";
  QTest::newRow("not there") << QStringList({"none.json"}) << "No such file";
  QTest::newRow("not here") << QStringList({"https://example.org/a.json"}) << "on this computer";
}

void FilesWindowTest::saysWhyADropIsNoScene() {
  QFETCH(QStringList, names);
  QFETCH(QString, reason);
  QFile note(m_folder->filePath("note.txt"));
  QVERIFY(note.open(QIODevice::WriteOnly));
  note.write("a note");
  note.close();
  MainWindow window(sceneOf(3));
  showInFront(window);
  QList<QUrl> urls;
  for (const QString& name : names) {
    urls << (name.startsWith("http") ? QUrl(name) : QUrl::fromLocalFile(m_folder->filePath(name)));
  }
  const Answers answers({QMessageBox::Ok});
  QVERIFY(drop(&window, urls));
  QCOMPARE(answers.texts.size(), 1);
  QVERIFY2(answers.texts.first().contains(reason), qPrintable(answers.texts.first()));
  QCOMPARE(weightsIn(window), std::size_t{3});
}

void FilesWindowTest::leavesDroppedTextToTheFields() {
  MainWindow window(sceneOf(3));
  showInFront(window);
  QMimeData data;
  data.setText("12");
  QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  enter.ignore();
  QApplication::sendEvent(&window, &enter);
  QVERIFY(!enter.isAccepted());
}

void FilesWindowTest::startsWithTheSceneOfLastTime() {
  const QString two = saved("two.json", 2);
  {
    MainWindow window(sceneOf(3));
    window.files()->open(two);
  }
  const ui::FirstScene first = ui::firstScene({});
  QCOMPARE(first.file, two);
  QCOMPARE(first.scene->weights.size(), std::size_t{2});
  QCOMPARE(first.message, QString());
}

void FilesWindowTest::startsWithTheBuiltInSceneOfLastTime() {
  {
    MainWindow window(sceneOf(3));
    window.files()->openBuiltIn("one-pendulum");
  }
  QCOMPARE(ui::firstScene({}).scene->name, ui::builtInScene("one-pendulum").name);
  QCOMPARE(ui::firstScene({}).file, QString());
  { const MainWindow window(sceneOf(3)); }  // nothing that could be found again
  QCOMPARE(ui::firstScene({}).scene->name, ui::builtInScene(ui::kDemonstration).name);
}

void FilesWindowTest::startsWithTheDemonstrationWhereTheLastSceneIsGone() {
  const QString two = saved("two.json", 2);
  { const MainWindow window(sceneOf(2), two); }
  QVERIFY(QFile::remove(two));
  const ui::FirstScene first = ui::firstScene({});
  QCOMPARE(first.scene->name, ui::builtInScene(ui::kDemonstration).name);
  QCOMPARE(first.file, QString());
  QVERIFY2(first.message.contains("two.json"), qPrintable(first.message));
}

void FilesWindowTest::theCommandLineWins() {
  { const MainWindow window(sceneOf(2), saved("two.json", 2)); }
  const QString one = saved("one.json", 1);
  QCOMPARE(ui::firstScene(one).scene->weights.size(), std::size_t{1});
  QCOMPARE(ui::firstScene(one).file, one);
  QVERIFY(!ui::firstScene(m_folder->filePath("none.json")).scene);
}

void FilesWindowTest::comesBackAsItWasLeft() {
  const QRect place(40, 50, 700, 560);
  {
    MainWindow window(sceneOf(3));
    showInFront(window);
    window.setWindowState(Qt::WindowNoState);
    window.setGeometry(place);
    QTest::keyClick(&window, Qt::Key_Comma);
    QTest::keyClick(&window, Qt::Key_Comma);
    QTest::keyClick(&window, Qt::Key_T);
    QTest::keyClick(&window, Qt::Key_PageDown, Qt::ControlModifier);
    QCOMPARE(window.charts()->kind(), 1);
    QVERIFY(window.close());
  }
  const MainWindow window(sceneOf(3));
  QCOMPARE(window.geometry().topLeft(), place.topLeft());
  QCOMPARE(window.controller()->speed(), 0.25);
  QVERIFY(!window.commands().action(Command::kTrails)->isChecked());
  QCOMPARE(window.charts()->kind(), 1);
}

QTEST_MAIN(FilesWindowTest)
#include "files_window_test.moc"
