#include "ui/control/scene_files.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <QtTest>

#include "core/scene/arrangement.h"
#include "ui/control/scene_editor.h"

class SceneFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void savesUnderAnEndingThatDesktopsKnow_data();
  void savesUnderAnEndingThatDesktopsKnow();

 private:
  QTemporaryDir m_folder;
};

void SceneFilesTest::initTestCase() {
  QStandardPaths::setTestModeEnabled(true);
  QVERIFY(QDir::setCurrent(m_folder.path()));
}

void SceneFilesTest::savesUnderAnEndingThatDesktopsKnow_data() {
  QTest::addColumn<QString>("typed");  // instead of what is suggested; empty: nothing
  QTest::addColumn<QString>("saved");
  QTest::newRow("as suggested") << ""
                                << "three-ropes.angrycuts.json";
  QTest::newRow("without an ending") << "lesson"
                                     << "lesson.angrycuts.json";
  QTest::newRow("with an ending") << "plain.json"
                                  << "plain.json";
}

void SceneFilesTest::savesUnderAnEndingThatDesktopsKnow() {
  QFETCH(QString, typed);
  QFETCH(QString, saved);
  core::Scene scene = core::withWeightCount(core::Scene(), 3);
  scene.name = typed.isEmpty() ? "Three ropes" : "No file of this name";
  ui::SceneEditor editor(scene);
  QWidget window;
  ui::SceneFiles files(&editor, {}, &window);
  QString asked;
  QTimer::singleShot(0, &window, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (!dialog) return;
    auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
    if (!typed.isEmpty()) name->selectAll();
    QTest::keyClicks(name, typed);
    // Asked again, about an older file say, it would wait for a person.
    QTimer::singleShot(0, dialog, [&asked, dialog] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box) asked = box->text();
      if (box) box->reject();
      if (box) dialog->reject();
    });
    auto* buttons = dialog->findChild<QDialogButtonBox*>();
    QTest::mouseClick(buttons->button(QDialogButtonBox::Save), Qt::LeftButton);
  });
  QVERIFY2(files.saveAs(), qPrintable(asked));
  QCOMPARE(QFileInfo(files.file()).fileName(), saved);
  QVERIFY(QFile::exists(m_folder.filePath(saved)));
}

QTEST_MAIN(SceneFilesTest)
#include "scene_files_test.moc"
