#include "ui/files/scene_file.h"

#include <algorithm>
#include <numbers>

#include <QtTest>

#include "core/trade/reference.h"
#include "tests/support/file_content.h"
#include "tests/support/processor_time.h"
#include "tests/support/small_disk.h"

using tests::contentOf;

namespace {

core::Weight swingingWeight() {
  core::Weight weight;
  weight.mass = 1.0 / 3;
  weight.color = core::Color{1, 2, 255};
  weight.rope = core::Rope{{1.1, 2.7}, 0.7, 2 * std::numbers::pi / 7, -1.0 / 7, true};
  return weight;
}

core::Weight freeWeight() {
  core::Weight weight;
  weight.radius = 0.1 + 0.2;
  weight.position = {3, 1.0 / 3};
  weight.velocity = {-1e-7, 99999.99999};
  return weight;
}

/// Every value set, most of them numbers that no short decimal names.
core::Scene awkwardScene() {
  core::Scene scene;
  scene.name = "\"Två\"\\\n\t\x01 🎯";
  scene.description = "≠";
  scene.gravity = 1.0 / 3;
  scene.airDensity = 1e-300;
  scene.room = {4.000000000000001, 3.1, 0.1, 2.0 / 3};
  scene.restitution = 0.30000000000000004;
  scene.cutTime = 1e22;
  scene.weights = {swingingWeight(), freeWeight()};
  scene.solvers = {{"euler", 1.0 / 60, 1e-9}, {"rk4", 1e-7, 1e-9}, {"dopri5", 1.0 / 60, 1e-5}};
  return scene;
}

bool areEqual(const core::Rope& a, const core::Rope& b) {
  return a.pivot == b.pivot && a.length == b.length && a.angle == b.angle &&
         a.angularVelocity == b.angularVelocity && a.rigid == b.rigid;
}

bool areEqual(const core::Weight& a, const core::Weight& b) {
  if (a.rope.has_value() != b.rope.has_value()) return false;
  if (a.rope && !areEqual(*a.rope, *b.rope)) return false;
  return a.mass == b.mass && a.radius == b.radius && a.dragCoefficient == b.dragCoefficient &&
         a.color == b.color && a.position == b.position && a.velocity == b.velocity;
}

bool areEqual(const core::Solver& a, const core::Solver& b) {
  return a.method == b.method && a.step == b.step && a.tolerance == b.tolerance;
}

template <class Entry>
bool areEqual(const std::vector<Entry>& a, const std::vector<Entry>& b) {
  return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return areEqual(x, y); });
}

bool areEqual(const core::Room& a, const core::Room& b) {
  return a.width == b.width && a.height == b.height && a.restitution == b.restitution &&
         a.friction == b.friction;
}

bool areEqual(const core::Scene& a, const core::Scene& b) {
  return a.name == b.name && a.description == b.description && a.gravity == b.gravity &&
         a.airDensity == b.airDensity && areEqual(a.room, b.room) &&
         a.restitution == b.restitution && a.cutTime == b.cutTime &&
         areEqual(a.weights, b.weights) && areEqual(a.solvers, b.solvers);
}

core::Scene crowd(int count) {
  core::Scene scene;
  scene.room = {1000, 1000, 0.8, 0};
  for (int i = 0; i < count; ++i) {
    const int row = i / 400;
    const int column = i % 400;
    core::Weight weight;
    weight.rope = core::Rope{{5 + column * 2.4 / 1.001, 5 + row * 3.7}, 0.731, i / 1e6, 0.1, false};
    scene.weights.push_back(weight);
  }
  return scene;
}

}  // namespace

class SceneFileTest : public QObject {
  Q_OBJECT

 private slots:
  void savedSceneReadsBackEqual();
  void writesNumbersAsAPersonWould();
  void writesNoReference();
  void writesTheSameTextAgain();
  void refusesFilesThatCannotBeRead();
  void refusesFilesOverSixtyFourMebibytes();
  void namesWhatKeepsAFileFromBeingWritten();
  void leavesTheOldFileWhereTheNewOneCannotBeWritten();
  void opensAHundredThousandWeightsQuickly();
  void refusesOneWeightTooMany();
};

void SceneFileTest::savedSceneReadsBackEqual() {
  QTemporaryDir folder;
  const QString file = folder.filePath("scene.json");
  QCOMPARE(ui::writeSceneFile(file, awkwardScene()), QString());
  const ui::SceneOrError read = ui::readSceneFile(file);
  QCOMPARE(read.error, QString());
  QVERIFY(areEqual(*read.scene, awkwardScene()));
}

void SceneFileTest::writesNoReference() {
  core::Scene scene;
  scene.solvers = {{.method = "euler"}, core::referenceSolver(0.01)};
  const QByteArray text = ui::sceneText(scene);
  QVERIFY(text.contains("\"euler\""));
  QVERIFY(!text.contains("reference"));
}

void SceneFileTest::writesNumbersAsAPersonWould() {
  const QByteArray text = ui::sceneText(ui::builtInScene("seven-weights"));
  QVERIFY(text.contains("\"angle\": 78,"));
  QVERIFY(text.contains("\"gravity\": 9.81,"));
  QVERIFY(text.contains("\"pivot\": [1, 2.8]"));
}

void SceneFileTest::writesTheSameTextAgain() {
  const QByteArray text = ui::sceneText(awkwardScene());
  QCOMPARE(ui::sceneText(*ui::parseScene(text).scene), text);
}

void SceneFileTest::refusesFilesThatCannotBeRead() {
  QTemporaryDir folder;
  QCOMPARE(ui::readSceneFile(folder.filePath("none.json")).error,
           QString("No such file or directory"));
  QVERIFY(!ui::readSceneFile(folder.path()).error.isEmpty());
}

void SceneFileTest::refusesFilesOverSixtyFourMebibytes() {
  QTemporaryDir folder;
  QFile file(folder.filePath("large.json"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  const QByteArray text = R"({"format": "angry-cuts/scene", "version": 1})";
  file.write(text);
  const qint64 limit = qint64{64} << 20;
  file.write(QByteArray(limit - text.size(), ' '));
  file.flush();
  QCOMPARE(ui::readSceneFile(file.fileName()).error, QString());
  file.write(" ");
  file.flush();
  QCOMPARE(ui::readSceneFile(file.fileName()).error, QString("larger than 64 MiB"));
}

void SceneFileTest::namesWhatKeepsAFileFromBeingWritten() {
  QTemporaryDir folder;
  QCOMPARE(ui::writeSceneFile(folder.filePath("none/scene.json"), core::Scene()),
           QString("No such file or directory"));
  QVERIFY(!ui::writeSceneFile(folder.path(), core::Scene()).isEmpty());
}

void SceneFileTest::leavesTheOldFileWhereTheNewOneCannotBeWritten() {
  // A limit on file sizes stands for a disk that fills up while the file is written.
  QTemporaryDir folder;
  const QString file = folder.filePath("scene.json");
  QCOMPARE(ui::writeSceneFile(file, awkwardScene()), QString());
  const QByteArray before = contentOf(file);

  QString error;
  {
    const SmallDisk disk(4096);
    error = ui::writeSceneFile(file, crowd(1000));
  }

  QCOMPARE(error, QString("File too large"));
  QCOMPARE(contentOf(file), before);
  QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"scene.json"});
}

void SceneFileTest::opensAHundredThousandWeightsQuickly() {
  const QByteArray text = ui::sceneText(crowd(100'000));
  ui::SceneOrError read;
  const double begin = tests::processorTime();
  read = ui::parseScene(text);
  const double used = tests::processorTime() - begin;
  QCOMPARE(read.error, QString());
  QCOMPARE(read.scene->weights.size(), std::size_t{100'000});
  // 0.4 s on a slow machine; without a grid for the overlaps it would take minutes.
  QVERIFY2(used < 20, qPrintable(QString::number(used)));
}

void SceneFileTest::refusesOneWeightTooMany() {
  QByteArray text = ui::sceneText(crowd(100'000));
  text.replace("\"weights\": [", "\"weights\": [{\"position\": [1, 1]},");
  QCOMPARE(ui::parseScene(text).error,
           QString("weights: must have 0 to 100000 entries, got 100001"));
}

QTEST_GUILESS_MAIN(SceneFileTest)
#include "scene_file_test.moc"
