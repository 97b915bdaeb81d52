#include <QtTest>

#include "ui/files/scene_file.h"

class BuiltInScenesTest : public QObject {
  Q_OBJECT

 private slots:
  void listsTheReportsScenesFirst();
  void describesEachSceneInOneSentence();
  void opensByNameOrAsAFile();
  void demonstrationShowsTwoMethodsOnSevenWeights();
};

void BuiltInScenesTest::listsTheReportsScenesFirst() {
  QCOMPARE(ui::builtInScenes().mid(0, 4),
           (QStringList{"one-pendulum", "two-weights", "three-pendulums", "seven-weights"}));
  QVERIFY(ui::builtInScenes().size() >= 12);
}

void BuiltInScenesTest::describesEachSceneInOneSentence() {
  for (const QString& name : ui::builtInScenes()) {
    const core::Scene scene = ui::builtInScene(name);
    QVERIFY(!scene.name.empty());
    const QString sentence = QString::fromStdString(scene.description);
    QVERIFY2(sentence.endsWith('.') && sentence.count('.') == 1, qPrintable(sentence));
  }
}

void BuiltInScenesTest::opensByNameOrAsAFile() {
  QTemporaryDir folder;
  const QString file = folder.filePath("mine.json");
  core::Scene scene;
  scene.name = "mine";
  QCOMPARE(ui::writeSceneFile(file, scene), QString());

  QCOMPARE(ui::readFileOrBuiltIn(file).scene->name, scene.name);
  QCOMPARE(ui::readFileOrBuiltIn("two-weights").scene->weights.size(), std::size_t{2});
  QCOMPARE(ui::readFileOrBuiltIn("no-such-scene").error,
           QString("no file or built-in scene of that name"));
}

void BuiltInScenesTest::demonstrationShowsTwoMethodsOnSevenWeights() {
  const core::Scene scene = ui::builtInScene("seven-weights");
  QCOMPARE(scene.weights.size(), std::size_t{7});
  QCOMPARE(scene.solvers.size(), std::size_t{2});
  QVERIFY(scene.cutTime);
}

QTEST_GUILESS_MAIN(BuiltInScenesTest)
#include "built_in_scenes_test.moc"
