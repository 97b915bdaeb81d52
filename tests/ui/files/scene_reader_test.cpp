#include <limits>

#include <QtTest>

#include "core/scene/angle.h"
#include "ui/files/scene_file.h"

namespace {

/// A scene file with these members besides format and version.
QByteArray fileWith(const QByteArray& members) {
  return R"({"format": "angry-cuts/scene", "version": 1)" +
         (members.isEmpty() ? QByteArray() : ", " + members) + '}';
}

QByteArray fileWithWeight(const QByteArray& members) {
  return fileWith("\"weights\": [{" + members + "}]");
}

QByteArray fileWithRope(const QByteArray& members) {
  return fileWithWeight("\"rope\": {" + members + "}");
}

QByteArray fileWithSolver(const QByteArray& members) {
  return fileWith("\"solvers\": [{" + members + "}]");
}

}  // namespace

class SceneReaderTest : public QObject {
  Q_OBJECT

 private slots:
  void readsEveryKey();
  void fillsInTheDefaults();
  void readsAScenesSolvers();
  void acceptsTheEndsOfEveryRange_data();
  void acceptsTheEndsOfEveryRange();
  void refusesFaults_data();
  void refusesFaults();
  void refusesTextThatIsNotUtf8();
  void refusesTextThatIsNotJsonWithItsPlace();
  void saysSoInOneShortLineWhateverTheFileHolds();
};

void SceneReaderTest::readsEveryKey() {
  const ui::SceneOrError read = ui::parseScene(R"({
    "format": "angry-cuts/scene", "version": 1,
    "name": "Två", "description": "One line",
    "gravity": 1.62, "airDensity": 0.5,
    "room": {"width": 5, "height": 6, "restitution": 0.7, "friction": 0.2},
    "restitution": 0.9, "cutTime": 0.9,
    "weights": [
      {"mass": 1.5, "radius": 0.1, "dragCoefficient": 0.3, "color": "#E69f00",
       "rope": {"pivot": [1.5, 4], "length": 2, "angle": 70, "angularVelocity": -90,
                "rigid": true}},
      {"position": [4, 1], "velocity": [1, -2]}
    ]})");
  QCOMPARE(read.error, QString());
  const core::Scene& scene = *read.scene;
  QCOMPARE(scene.name, std::string("Två"));
  QCOMPARE(scene.description, std::string("One line"));
  QCOMPARE(scene.gravity, 1.62);
  QCOMPARE(scene.airDensity, 0.5);
  QCOMPARE(scene.room.width, 5.0);
  QCOMPARE(scene.room.height, 6.0);
  QCOMPARE(scene.room.restitution, 0.7);
  QCOMPARE(scene.room.friction, 0.2);
  QCOMPARE(scene.restitution, 0.9);
  QCOMPARE(scene.cutTime.value(), 0.9);
  QCOMPARE(scene.weights.size(), std::size_t{2});

  const core::Weight& swinging = scene.weights[0];
  QCOMPARE(swinging.mass, 1.5);
  QCOMPARE(swinging.radius, 0.1);
  QCOMPARE(swinging.dragCoefficient, 0.3);
  QVERIFY(swinging.color == (core::Color{0xe6, 0x9f, 0x00}));
  QVERIFY(swinging.rope->pivot == Eigen::Vector2d(1.5, 4));
  QCOMPARE(swinging.rope->length, 2.0);
  QCOMPARE(swinging.rope->angle, core::radians(70));
  QCOMPARE(swinging.rope->angularVelocity, core::radians(-90));
  QVERIFY(swinging.rope->rigid);

  QVERIFY(!scene.weights[1].rope);
  QVERIFY(scene.weights[1].position == Eigen::Vector2d(4, 1));
  QVERIFY(scene.weights[1].velocity == Eigen::Vector2d(1, -2));
}

void SceneReaderTest::fillsInTheDefaults() {
  const ui::SceneOrError read = ui::parseScene(fileWithRope(R"("pivot": [2, 2])"));
  QCOMPARE(read.error, QString());
  const core::Scene& scene = *read.scene;
  QCOMPARE(scene.name, std::string());
  QCOMPARE(scene.gravity, 9.81);
  QCOMPARE(scene.airDensity, 1.2);
  QCOMPARE(scene.room.width, 4.0);
  QCOMPARE(scene.room.height, 3.0);
  QCOMPARE(scene.room.restitution, 0.8);
  QCOMPARE(scene.room.friction, 0.0);
  QCOMPARE(scene.restitution, 1.0);
  QVERIFY(!scene.cutTime);
  QVERIFY(scene.solvers.empty());
  const core::Weight& weight = scene.weights.front();
  QCOMPARE(weight.mass, 0.19);
  QCOMPARE(weight.radius, 0.02);
  QCOMPARE(weight.dragCoefficient, 0.47);
  QVERIFY(!weight.color);
  QCOMPARE(weight.rope->length, 1.0);
  QCOMPARE(weight.rope->angle, 0.0);
  QCOMPARE(weight.rope->angularVelocity, 0.0);
  QVERIFY(!weight.rope->rigid);
}

void SceneReaderTest::readsAScenesSolvers() {
  const ui::SceneOrError read = ui::parseScene(
      fileWith(R"("solvers": [{"method": "euler", "step": 0.0166667}, {"method": "rk4"},
                              {"method": "dopri5", "tolerance": 1e-6}, {"method": "dopri5"}])"));
  QCOMPARE(read.error, QString());
  QCOMPARE(read.scene->solvers.size(), std::size_t{4});
  QCOMPARE(read.scene->solvers[0].method, std::string("euler"));
  QCOMPARE(read.scene->solvers[0].step, 0.0166667);
  QCOMPARE(read.scene->solvers[1].method, std::string("rk4"));
  QCOMPARE(read.scene->solvers[1].step, 1.0 / 60);
  QCOMPARE(read.scene->solvers[2].method, std::string("dopri5"));
  QCOMPARE(read.scene->solvers[2].tolerance, 1e-6);
  QCOMPARE(read.scene->solvers[3].tolerance, 1e-9);
}

void SceneReaderTest::acceptsTheEndsOfEveryRange_data() {
  QTest::addColumn<QByteArray>("text");
  const auto row = [](const char* name, const QByteArray& text) { QTest::newRow(name) << text; };
  row("lowest", fileWith(R"("gravity": 0, "airDensity": 0, "restitution": 0, "cutTime": 0,
      "room": {"width": 0.01, "height": 0.01, "restitution": 0, "friction": 0})"));
  row("highest", fileWith(R"("gravity": 1000, "airDensity": 2000, "restitution": 1,
      "cutTime": 1e300, "room": {"width": 1e5, "height": 1e5, "restitution": 1, "friction": 10})"));
  row("lightest", fileWithWeight(R"("mass": 1e-6, "radius": 1e-4, "dragCoefficient": 0,
      "position": [1, 1], "velocity": [-1e5, 1e5])"));
  row("heaviest", fileWith(R"("room": {"width": 300, "height": 300}, "weights": [{"mass": 1e9,
      "radius": 100, "dragCoefficient": 10, "position": [150, 150]}])"));
  row("shortest rope", fileWithRope(R"("pivot": [2, 2], "length": 0.001, "angle": -180,
      "angularVelocity": -1e5)"));
  row("longest rope", fileWith(R"("room": {"width": 3e4, "height": 3e4}, "weights": [{"rope":
      {"pivot": [15000, 15000], "length": 1e4, "angle": 180, "angularVelocity": 1e5}}])"));
  row("no weights", fileWith(R"("weights": [])"));
  row("cut by hand", fileWith(R"("cutTime": null)"));
}

void SceneReaderTest::acceptsTheEndsOfEveryRange() {
  QFETCH(QByteArray, text);
  QCOMPARE(ui::parseScene(text).error, QString());
}

void SceneReaderTest::refusesFaults_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("error");
  const auto row = [](const char* name, const QByteArray& text, const char* error) {
    QTest::newRow(name) << text << QString(error);
  };
  row("no object", "[]", "scene: must be an object, got a list");
  row("no format", R"({"version": 1})", "format: is missing");
  row("another format", R"({"format": "cuts", "version": 1})",
      R"(format: must be "angry-cuts/scene", got "cuts")");
  row("no version", R"({"format": "angry-cuts/scene"})", "version: is missing");
  row("newer version", R"({"colour": 1, "format": "angry-cuts/scene", "version": 2})",
      "version: 2 is newer than this program, which reads version 1");
  row("version below 1", R"({"format": "angry-cuts/scene", "version": 0})",
      "version: must be 1, got 0");
  row("version as text", R"({"format": "angry-cuts/scene", "version": "1"})",
      "version: must be a number, got a text");

  row("unknown key", fileWith(R"("colour": 1)"), R"(scene: unknown key "colour")");
  row("unknown key in room", fileWith(R"("room": {"depth": 1})"), R"(room: unknown key "depth")");
  row("unknown key in weight", fileWithWeight(R"("weight": 1)"),
      R"(weights[0]: unknown key "weight")");
  row("unknown key in rope", fileWithRope(R"("lenght": 1)"),
      R"(weights[0].rope: unknown key "lenght")");
  row("unknown key in solver", fileWithSolver(R"("h": 1)"), R"(solvers[0]: unknown key "h")");
  row("key twice", fileWith(R"("gravity": 1, "gravity": 2)"), "gravity: stands twice");
  row("key twice in rope", fileWithRope(R"("length": 1, "length": 1)"),
      "weights[0].rope.length: stands twice");
  row("version twice", fileWith(R"("version": 1)"), "version: stands twice");

  row("text for a number", fileWith(R"("gravity": "9.81")"),
      "gravity: must be a number, got a text");
  row("null for a number", fileWith(R"("gravity": null)"), "gravity: must be a number, got null");
  row("number for a text", fileWith(R"("name": 7)"), "name: must be a text, got a number");
  row("number for true or false", fileWithRope(R"("rigid": 1)"),
      "weights[0].rope.rigid: must be true or false, got a number");
  row("list for an object", fileWith(R"("room": [4, 3])"), "room: must be an object, got a list");
  row("object for a list", fileWith(R"("weights": {})"), "weights: must be a list, got an object");
  row("number for a weight", fileWith(R"("weights": [1])"),
      "weights[0]: must be an object, got a number");
  row("text for the cut", fileWith(R"("cutTime": "never")"),
      "cutTime: must be a number, got a text");
  row("one number for two", fileWithWeight(R"("position": [1])"),
      "weights[0].position: must have 2 entries, got 1");
  row("three numbers for two", fileWithWeight(R"("position": [1, 1, 1])"),
      "weights[0].position: must have 2 entries, got 3");
  row("text in a position", fileWithWeight(R"("position": [1, "a"])"),
      "weights[0].position[1]: must be a number, got a text");
  row("color by name", fileWithWeight(R"("color": "red")"),
      R"(weights[0].color: must be like "#e69f00", got "red")");
  row("color too long", fileWithWeight(R"("color": "#e69f000")"),
      R"(weights[0].color: must be like "#e69f00", got "#e69f000")");
  row("color with another digit", fileWithWeight(R"("color": "#e69f0g")"),
      R"(weights[0].color: must be like "#e69f00", got "#e69f0g")");

  row("gravity", fileWith(R"("gravity": -1)"), "gravity: must be from 0 to 1000 m/s², got -1");
  row("air density", fileWith(R"("airDensity": 2001)"),
      "airDensity: must be from 0 to 2000 kg/m³, got 2001");
  row("room width", fileWith(R"("room": {"width": 0})"),
      "room.width: must be from 0.01 to 100000 m, got 0");
  row("room height", fileWith(R"("room": {"height": 1e6})"),
      "room.height: must be from 0.01 to 100000 m, got 1000000");
  row("room restitution", fileWith(R"("room": {"restitution": 1.1})"),
      "room.restitution: must be from 0 to 1, got 1.1");
  row("room friction", fileWith(R"("room": {"friction": -0.1})"),
      "room.friction: must be from 0 to 10, got -0.1");
  row("restitution", fileWith(R"("restitution": 2)"), "restitution: must be from 0 to 1, got 2");
  row("cut time", fileWith(R"("cutTime": -1)"), "cutTime: must be at least 0 s, got -1");
  row("not finite", fileWith(R"("gravity": 1e999)"),
      R"(gravity: "1e999" is too large or too small to reckon with)");
  row("mass", fileWithWeight(R"("position": [1, 1], "mass": 0)"),
      "weights[0].mass: must be from 1e-6 to 1e9 kg, got 0");
  row("radius", fileWithWeight(R"("position": [1, 1], "radius": 0)"),
      "weights[0].radius: must be from 0.0001 to 100 m, got 0");
  row("drag coefficient", fileWithWeight(R"("position": [1, 1], "dragCoefficient": 11)"),
      "weights[0].dragCoefficient: must be from 0 to 10, got 11");
  row("rope length", fileWithRope(R"("pivot": [1, 1], "length": -1)"),
      "weights[0].rope.length: must be from 0.001 to 10000 m, got -1");
  row("rope angle", fileWithRope(R"("pivot": [2, 2], "angle": 180.5)"),
      "weights[0].rope.angle: must be from -180 to 180 °, got 180.5");
  row("angular velocity", fileWithRope(R"("pivot": [2, 2], "angularVelocity": 100001)"),
      "weights[0].rope.angularVelocity: must be from -100000 to 100000 °/s, got 100001");
  row("velocity", fileWithWeight(R"("position": [1, 1], "velocity": [0, 2e5])"),
      "weights[0].velocity[1]: must be from -100000 to 100000 m/s, got 200000");

  row("neither rope nor position", fileWithWeight(""),
      "weights[0]: must have either rope or position, got neither");
  row("both rope and position", fileWithWeight(R"("rope": {"pivot": [2, 2]}, "position": [1, 1])"),
      "weights[0]: must have either rope or position, got both");
  row("velocity on a rope", fileWithWeight(R"("rope": {"pivot": [2, 2]}, "velocity": [1, 1])"),
      "weights[0]: velocity goes with position, got it with rope");
  row("no pivot", fileWithRope(""), "weights[0].rope.pivot: is missing");
  row("pivot outside the room", fileWithRope(R"("pivot": [2, 3.5])"),
      "weights[0].rope.pivot: must be inside the room, got [2, 3.5]");
  row("weight through the floor", fileWithWeight(R"("position": [2, 0.01])"),
      "weights[0].position: must put the whole weight, of radius 0.02 m, inside the room, got "
      "[2, 0.01]");
  row("rope through the floor", fileWithRope(R"("pivot": [2, 2], "length": 2.5)"),
      "weights[0].rope: must put the whole weight, of radius 0.02 m, inside the room, got "
      "[2, -0.5]");
  row("overlap", fileWith(R"("weights": [{"position": [1, 1]}, {"position": [2, 1]},
                              {"position": [1.03, 1]}])"),
      "weights[2]: must not overlap weights[0] at the start");

  row("no solvers", fileWith(R"("solvers": [])"), "solvers: must have 1 to 4 entries, got 0");
  row("five solvers",
      fileWith(R"("solvers": [{"method": "rk4"}, {"method": "rk4"}, {"method": "rk4"},
                              {"method": "rk4"}, {"method": "rk4"}])"),
      "solvers: must have 1 to 4 entries, got 5");
  row("unknown method", fileWithSolver(R"("method": "magic")"),
      R"(solvers[0].method: there is no method named "magic")");
  row("no method", fileWithSolver(R"("step": 0.1)"), "solvers[0].method: is missing");
  row("step", fileWithSolver(R"("method": "rk4", "step": 20)"),
      "solvers[0].step: must be from 1e-7 to 10 s, got 20");
  row("tolerance of a method with a step", fileWithSolver(R"("method": "rk4", "tolerance": 1e-9)"),
      "solvers[0].tolerance: rk4 takes a step, not a tolerance");
  row("step of a method with a tolerance", fileWithSolver(R"("method": "dopri5", "step": 0.1)"),
      "solvers[0].step: dopri5 takes a tolerance, not a step");
  row("tolerance", fileWithSolver(R"("method": "dopri5", "tolerance": 2)"),
      "solvers[0].tolerance: must be from 1e-14 to 1, got 2");
  row("method of the program's own", fileWithSolver(R"("method": "reference")"),
      R"(solvers[0].method: there is no method named "reference")");
}

void SceneReaderTest::refusesFaults() {
  QFETCH(QByteArray, text);
  QFETCH(QString, error);
  const ui::SceneOrError read = ui::parseScene(text);
  QCOMPARE(read.error, error);
  QVERIFY(!read.scene);
}

void SceneReaderTest::refusesTextThatIsNotUtf8() {
  QCOMPARE(ui::parseScene(fileWith("\"name\": \"Tv\xe5\"")).error, QString("not UTF-8"));
}

void SceneReaderTest::refusesTextThatIsNotJsonWithItsPlace() {
  QCOMPARE(ui::parseScene("{\n  \"format\": angry\n}").error,
           QString("not JSON: line 2, column 13: a value must stand here"));
}

void SceneReaderTest::saysSoInOneShortLineWhateverTheFileHolds() {
  const QByteArray key = "line\\nbreak" + QByteArray(1'000'000, 'x');
  const QString error = ui::parseScene(fileWith('"' + key + "\": 1")).error;
  QVERIFY(error.startsWith(QString("scene: unknown key \"line") + QChar(0xFFFD) + "breakxxx"));
  QVERIFY(error.size() < 100);
}

QTEST_GUILESS_MAIN(SceneReaderTest)
#include "scene_reader_test.moc"
