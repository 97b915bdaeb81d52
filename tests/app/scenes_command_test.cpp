#include <QtTest>

#include "tests/support/called_program.h"
#include "ui/files/scene_file.h"

using tests::Outcome;

namespace {

// A weight in flight without air: every step of RK4 is exact but for rounding.
const QByteArray kThrown = R"({"format": "angry-cuts/scene", "version": 1, "gravity": 10,
    "airDensity": 0, "room": {"width": 10, "height": 10, "restitution": 0.5},
    "weights": [{"mass": 2, "radius": 0.5, "position": [1, 5.5], "velocity": [1, 0]}]})";

}  // namespace

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
  m_thrown = m_program.write("thrown.json", kThrown);
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
