// Drives the window as a person does who opens and saves scenes.
#include <QFile>
#include <QLocale>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/answer.h"
#include "tests/support/fields.h"
#include "tests/support/shown_window.h"
#include "tests/support/swinging_scene.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"

using tests::Answer;
using tests::swingingScene;
using ui::MainWindow;

class SceneFilesWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void asksAboutUnsavedChanges_data();
  void asksAboutUnsavedChanges();
  void savesAndOpensScenes();
  void aFileWithAFaultLeavesTheSceneAndSaysWhere();
  void opensEveryBuiltInSceneFromTheMenu();

 private:
  QString inFolder(const QString& name) const { return m_folder.filePath(name); }

  QTemporaryDir m_folder;
};

void SceneFilesWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void SceneFilesWindowTest::asksAboutUnsavedChanges_data() {
  QTest::addColumn<QMessageBox::StandardButton>("button");
  QTest::addColumn<bool>("closed");
  QTest::addColumn<bool>("saved");
  QTest::newRow("save") << QMessageBox::Save << true << true;
  QTest::newRow("discard") << QMessageBox::Discard << true << false;
  QTest::newRow("cancel") << QMessageBox::Cancel << false << false;
}

void SceneFilesWindowTest::asksAboutUnsavedChanges() {
  QFETCH(QMessageBox::StandardButton, button);
  QFETCH(bool, closed);
  QFETCH(bool, saved);
  const QString file = inFolder("unsaved.json");
  QCOMPARE(ui::writeSceneFile(file, swingingScene()), QString());
  MainWindow window(swingingScene(), file);
  tests::showInFront(window);
  tests::enter(tests::fieldNamed(window, "Gravity"), "1.62");
  Answer answer(button);
  window.close();
  QVERIFY(answer.text.contains("not saved"));
  QCOMPARE(window.isVisible(), !closed);
  QCOMPARE(ui::readSceneFile(file).scene->gravity, saved ? 1.62 : 9.81);
  window.editor()->setSaved();
}

void SceneFilesWindowTest::savesAndOpensScenes() {
  const QString file = inFolder("saved.json");
  {
    MainWindow window(swingingScene());
    tests::showInFront(window);
    tests::enter(tests::fieldNamed(window, "Air density"), "0");
    QVERIFY(window.files()->saveTo(file));
    QVERIFY(!window.isWindowModified());
    QVERIFY(window.windowTitle().startsWith("saved.json"));
  }
  MainWindow window(swingingScene());
  window.files()->open(file);
  QCOMPARE(window.controller()->scene().airDensity, 0.0);
  QCOMPARE(tests::fieldNamed(window, "Air density")->spinBox()->text(), QString("0 kg/m³"));
}

void SceneFilesWindowTest::aFileWithAFaultLeavesTheSceneAndSaysWhere() {
  const QString name = inFolder("fault.json");
  QFile file(name);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(ui::sceneText(swingingScene()).replace("9.81", "-9.81"));
  file.close();
  MainWindow window(swingingScene());
  Answer answer(QMessageBox::Ok);
  window.files()->open(name);
  QVERIFY(answer.text.contains("gravity"));
  QCOMPARE(window.controller()->scene().name, std::string("Some that swing"));
}

void SceneFilesWindowTest::opensEveryBuiltInSceneFromTheMenu() {
  MainWindow window(swingingScene());
  for (const QString& name : ui::builtInScenes()) {
    window.files()->openBuiltIn(name);
    QCOMPARE(window.controller()->scene().name, ui::builtInScene(name).name);
    QVERIFY(!window.controller()->isPlaying());
    window.controller()->stepOnce();
  }
}

QTEST_MAIN(SceneFilesWindowTest)
#include "scene_files_window_test.moc"
