#include <QtTest>

#include "tests/app/thrown_scene.h"
#include "tests/support/called_program.h"
#include "ui/files/scene_file.h"

using tests::Outcome;

/// `angrycuts scenes`, called as a user calls it.
class ScenesCommandTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void listsScenesWithOneSentenceEach();
  void exportsScenesAsFiles();
  void saysWhatKeepsScenesFromBeingExported();

 private:
  tests::CalledProgram m_program{ANGRYCUTS_PROGRAM};
  QString m_thrown;
};

void ScenesCommandTest::initTestCase() {
  m_thrown = m_program.write("thrown.json", tests::kThrown);
}

void ScenesCommandTest::listsScenesWithOneSentenceEach() {
  const Outcome outcome = m_program.call({"scenes"});
  QCOMPARE(outcome.status, 0);
  QStringList names;
  for (const QByteArray& line : outcome.output.trimmed().split('\n')) {
    const QByteArrayList fields = line.split('\t');
    QCOMPARE(fields.size(), 2);
    names.append(fields[0]);
    QVERIFY(fields[1].endsWith('.'));
  }
  QCOMPARE(names, ui::builtInScenes());
}

void ScenesCommandTest::exportsScenesAsFiles() {
  const QString folder = m_program.path("new/scenes");
  QCOMPARE(m_program.call({"scenes", "--export", folder}).status, 0);
  for (const QString& name : ui::builtInScenes()) {
    const ui::SceneOrError read = ui::readSceneFile(folder + '/' + name + ".json");
    QCOMPARE(read.error, QString());
    QCOMPARE(ui::sceneText(*read.scene), ui::sceneText(ui::builtInScene(name)));
  }
}

void ScenesCommandTest::saysWhatKeepsScenesFromBeingExported() {
  const Outcome outcome = m_program.call({"scenes", "--export", m_thrown});
  QCOMPARE(outcome.status, 1);
  QCOMPARE(outcome.error, "angrycuts: " + m_thrown.toUtf8() + ": the folder cannot be made\n");
}

QTEST_GUILESS_MAIN(ScenesCommandTest)
#include "scenes_command_test.moc"
