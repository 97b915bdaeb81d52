#include "core/scene/scene_limits.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <QtTest>

#include "core/scene/angle.h"

using core::Problem;
using core::Scene;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A sound scene: weights[0] is free, weights[1] hangs.
Scene soundScene() {
  Scene scene;
  scene.weights.resize(2);
  scene.weights[0].position = {0.5, 0.5};
  scene.weights[1].rope = core::Rope{{2, 2.5}, 1, 0, 0, false};
  scene.solvers.resize(1);
  return scene;
}

/// One row of the table in the description of scene files.
struct Quantity {
  const char* place;
  double lowest;
  double highest;
  std::function<void(Scene&, double)> set;
};

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> kQuantities{
      {"gravity", 0, 1000, [](Scene& s, double v) { s.gravity = v; }},
      {"airDensity", 0, 2000, [](Scene& s, double v) { s.airDensity = v; }},
      {"room.width", 0.01, 1e5, [](Scene& s, double v) { s.room.width = v; }},
      {"room.height", 0.01, 1e5, [](Scene& s, double v) { s.room.height = v; }},
      {"room.restitution", 0, 1, [](Scene& s, double v) { s.room.restitution = v; }},
      {"room.friction", 0, 10, [](Scene& s, double v) { s.room.friction = v; }},
      {"restitution", 0, 1, [](Scene& s, double v) { s.restitution = v; }},
      {"cutTime", 0, 1e300, [](Scene& s, double v) { s.cutTime = v; }},
      {"weights[0].mass", 1e-6, 1e9, [](Scene& s, double v) { s.weights[0].mass = v; }},
      {"weights[0].radius", 1e-4, 100, [](Scene& s, double v) { s.weights[0].radius = v; }},
      {"weights[0].dragCoefficient", 0, 10,
       [](Scene& s, double v) { s.weights[0].dragCoefficient = v; }},
      {"weights[0].velocity[0]", -1e5, 1e5,
       [](Scene& s, double v) { s.weights[0].velocity.x() = v; }},
      {"weights[0].velocity[1]", -1e5, 1e5,
       [](Scene& s, double v) { s.weights[0].velocity.y() = v; }},
      {"weights[1].mass", 1e-6, 1e9, [](Scene& s, double v) { s.weights[1].mass = v; }},
      {"weights[1].rope.length", 1e-3, 1e4,
       [](Scene& s, double v) { s.weights[1].rope->length = v; }},
      {"weights[1].rope.angle", -180, 180,
       [](Scene& s, double v) { s.weights[1].rope->angle = core::radians(v); }},
      {"weights[1].rope.angularVelocity", -1e5, 1e5,
       [](Scene& s, double v) { s.weights[1].rope->angularVelocity = core::radians(v); }},
      {"solvers[0].step", 1e-7, 10, [](Scene& s, double v) { s.solvers[0].step = v; }},
      {"solvers[0].tolerance", 1e-14, 1, [](Scene& s, double v) { s.solvers[0].tolerance = v; }},
  };
  return kQuantities;
}

/// A little beyond a bound, on the side `direction` points to.
double beyond(double bound, int direction) {
  return bound + direction * 1e-9 * std::max(std::abs(bound), 1e-9);
}

bool isRefused(const Quantity& quantity, double value) {
  Scene scene = soundScene();
  quantity.set(scene, value);
  return std::ranges::any_of(core::problemsIn(scene), [&](const Problem& problem) {
    return problem.place == quantity.place && problem.kind == Problem::Kind::kOutOfRange;
  });
}

QStringList places(const Scene& scene) {
  QStringList places;
  for (const Problem& problem : core::problemsIn(scene)) {
    places << QString::fromStdString(problem.place);
  }
  return places;
}

core::Weight freeWeight(double x, double y, double radius = 0.02) {
  core::Weight weight;
  weight.position = {x, y};
  weight.radius = radius;
  return weight;
}

}  // namespace

class SceneLimitsTest : public QObject {
  Q_OBJECT

 private slots:
  void acceptsASoundScene();
  void acceptsAnEmptyScene();
  void holdsEveryRange_data();
  void holdsEveryRange();
  void saysWhatWasGotAndWhatIsAllowed_data();
  void saysWhatWasGotAndWhatIsAllowed();
  void saysWhatIsOutsideTheRoom_data();
  void saysWhatIsOutsideTheRoom();
  void saysWhichWeightsOverlap();
  void listsAllFaultsInTheOrderOfTheFile();
  void keepsPivotsAndWeightsInTheRoom_data();
  void keepsPivotsAndWeightsInTheRoom();
  void blamesOnlyTheRoomForItsSize();
  void acceptsWeightsThatTouchWallsAndEachOther();
  void countsWeightsAndSolvers();
  void writesNumbersAsAPersonWould_data();
  void writesNumbersAsAPersonWould();
};

void SceneLimitsTest::acceptsASoundScene() {
  QCOMPARE(places(soundScene()), QStringList());
}

void SceneLimitsTest::acceptsAnEmptyScene() {
  QCOMPARE(places(Scene()), QStringList());
}

void SceneLimitsTest::holdsEveryRange_data() {
  QTest::addColumn<int>("index");
  for (std::size_t i = 0; i < quantities().size(); ++i) {
    QTest::newRow(quantities()[i].place) << static_cast<int>(i);
  }
}

void SceneLimitsTest::holdsEveryRange() {
  QFETCH(int, index);
  const Quantity& quantity = quantities()[index];
  QVERIFY(!isRefused(quantity, quantity.lowest));
  QVERIFY(!isRefused(quantity, quantity.highest));
  QVERIFY(isRefused(quantity, beyond(quantity.lowest, -1)));
  const bool hasUpperEnd = QByteArray(quantity.place) != "cutTime";
  QCOMPARE(isRefused(quantity, beyond(quantity.highest, +1)), hasUpperEnd);
  QVERIFY(isRefused(quantity, kNaN));
  QVERIFY(isRefused(quantity, kInfinity));
  QVERIFY(isRefused(quantity, -kInfinity));
}

void SceneLimitsTest::saysWhatWasGotAndWhatIsAllowed_data() {
  QTest::addColumn<Scene>("scene");
  QTest::addColumn<QString>("place");
  QTest::addColumn<double>("value");
  QTest::addColumn<core::Range>("allowed");
  const auto add = [](const char* place, double value, const core::Range& allowed,
                      const std::function<void(Scene&)>& spoil) {
    Scene scene = soundScene();
    spoil(scene);
    QTest::newRow(place) << scene << place << value << allowed;
  };
  add("weights[1].rope.length", -1, core::kRopeLengthRange,
      [](Scene& s) { s.weights[1].rope->length = -1; });
  add("cutTime", -1, core::kCutTimeRange, [](Scene& s) { s.cutTime = -1; });
  add("room.restitution", 1.5, core::kRestitutionRange, [](Scene& s) { s.room.restitution = 1.5; });
  add("weights[1].rope.angle", 200, core::kRopeAngleRange,
      [](Scene& s) { s.weights[1].rope->angle = core::radians(200); });
  add("gravity", kInfinity, core::kGravityRange, [](Scene& s) { s.gravity = kInfinity; });
}

void SceneLimitsTest::saysWhatWasGotAndWhatIsAllowed() {
  QFETCH(Scene, scene);
  QFETCH(QString, place);
  QFETCH(double, value);
  QFETCH(core::Range, allowed);
  const std::vector<Problem> problems = core::problemsIn(scene);
  QCOMPARE(problems.size(), std::size_t{1});
  QCOMPARE(problems[0].kind, Problem::Kind::kOutOfRange);
  QCOMPARE(QString::fromStdString(problems[0].place), place);
  QCOMPARE(problems[0].value, value);
  QCOMPARE(problems[0].allowed.lowest, allowed.lowest);
  QCOMPARE(problems[0].allowed.highest, allowed.highest);
  QCOMPARE(problems[0].allowed.unit, allowed.unit);
}

void SceneLimitsTest::saysWhatIsOutsideTheRoom_data() {
  QTest::addColumn<Scene>("scene");
  QTest::addColumn<QString>("place");
  QTest::addColumn<double>("radius");
  QTest::addColumn<double>("x");
  QTest::addColumn<double>("y");
  const auto add = [](const char* place, double radius, double x, double y,
                      const std::function<void(Scene&)>& spoil) {
    Scene scene = soundScene();
    spoil(scene);
    QTest::newRow(place) << scene << place << radius << x << y;
  };
  add("weights[1].rope.pivot", 0, 2, 3.5, [](Scene& s) { s.weights[1].rope->pivot.y() = 3.5; });
  add("weights[0].position", 0.02, 0.01, 1, [](Scene& s) { s.weights[0].position = {0.01, 1}; });
  add("weights[1].rope", 0.02, 2, -0.5, [](Scene& s) { s.weights[1].rope->length = 3; });
}

void SceneLimitsTest::saysWhatIsOutsideTheRoom() {
  QFETCH(Scene, scene);
  QFETCH(QString, place);
  QFETCH(double, radius);
  QFETCH(double, x);
  QFETCH(double, y);
  const std::vector<Problem> problems = core::problemsIn(scene);
  QCOMPARE(problems.size(), std::size_t{1});
  QCOMPARE(problems[0].kind, Problem::Kind::kOutsideRoom);
  QCOMPARE(QString::fromStdString(problems[0].place), place);
  QCOMPARE(problems[0].value, radius);
  QCOMPARE(problems[0].at, Eigen::Vector2d(x, y));
}

void SceneLimitsTest::saysWhichWeightsOverlap() {
  Scene scene = soundScene();
  scene.weights[0].position = {2.03, 1.5};
  const std::vector<Problem> problems = core::problemsIn(scene);
  QCOMPARE(problems.size(), std::size_t{1});
  QCOMPARE(problems[0].kind, Problem::Kind::kOverlap);
  QCOMPARE(problems[0].place, std::string("weights[1]"));
  QCOMPARE(problems[0].other, 0);
}

void SceneLimitsTest::listsAllFaultsInTheOrderOfTheFile() {
  Scene scene = soundScene();
  scene.gravity = -1;
  scene.airDensity = kNaN;
  scene.room.friction = 11;
  scene.restitution = 2;
  scene.weights[0].mass = 0;
  scene.weights[0].velocity = {1e6, -1e6};
  scene.weights[1].rope->angularVelocity = kInfinity;
  scene.weights.push_back(scene.weights[0]);
  scene.solvers[0].step = 0;
  QCOMPARE(places(scene), QStringList({"gravity", "airDensity", "room.friction", "restitution",
                                       "weights[0].mass", "weights[0].velocity[0]",
                                       "weights[0].velocity[1]", "weights[1].rope.angularVelocity",
                                       "weights[2].mass", "weights[2].velocity[0]",
                                       "weights[2].velocity[1]", "weights[2]", "solvers[0].step"}));
}

void SceneLimitsTest::keepsPivotsAndWeightsInTheRoom_data() {
  QTest::addColumn<double>("x");
  QTest::addColumn<double>("y");
  QTest::addColumn<bool>("pivotIsInside");
  QTest::addColumn<bool>("weightIsInside");
  // The room is 4 m × 3 m, the weight's radius 0.02 m.
  QTest::newRow("middle") << 2.0 << 1.5 << true << true;
  QTest::newRow("on the ceiling") << 2.0 << 3.0 << true << false;
  QTest::newRow("in a corner") << 0.0 << 0.0 << true << false;
  QTest::newRow("touching two walls") << 3.98 << 2.98 << true << true;
  QTest::newRow("a hair too low") << 2.0 << 0.02 - 1e-10 << true << false;
  QTest::newRow("west of the room") << -1e-9 << 1.0 << false << false;
  QTest::newRow("east of the room") << 4.1 << 1.0 << false << false;
  QTest::newRow("above the room") << 2.0 << 3.1 << false << false;
  QTest::newRow("below the room") << 2.0 << -5.0 << false << false;
  QTest::newRow("nowhere") << kNaN << 1.0 << false << false;
  QTest::newRow("infinitely far") << 1.0 << kInfinity << false << false;
}

void SceneLimitsTest::keepsPivotsAndWeightsInTheRoom() {
  QFETCH(double, x);
  QFETCH(double, y);
  QFETCH(bool, pivotIsInside);
  QFETCH(bool, weightIsInside);
  Scene scene;
  scene.weights = {freeWeight(x, y)};
  QCOMPARE(core::problemsIn(scene).empty(), weightIsInside);

  // On a rope of one millimeter's length the weight starts below its pivot.
  scene.weights[0].rope = core::Rope{{x, y + 0.001}, 0.001, 0, 0, false};
  QCOMPARE(core::problemsIn(scene).empty(), weightIsInside);

  scene.weights[0].rope = core::Rope{{x, y}, 1, 0, 0, false};
  const auto problems = core::problemsIn(scene);
  const auto isPivot = [](const Problem& p) { return p.place == "weights[0].rope.pivot"; };
  QCOMPARE(std::ranges::none_of(problems, isPivot), pivotIsInside);
}

void SceneLimitsTest::blamesOnlyTheRoomForItsSize() {
  Scene scene = soundScene();
  scene.room.height = kNaN;
  QCOMPARE(places(scene), QStringList("room.height"));
}

void SceneLimitsTest::acceptsWeightsThatTouchWallsAndEachOther() {
  // 0.3 − 0.1 is less than 0.2 in doubles: touching must survive that.
  Scene scene;
  scene.room.width = 0.3;
  scene.weights = {freeWeight(0.2, 0.1, 0.1), freeWeight(0.1, 2.9, 0.1), freeWeight(0.2, 0.3, 0.1)};
  QCOMPARE(places(scene), QStringList());
}

void SceneLimitsTest::countsWeightsAndSolvers() {
  Scene scene;
  scene.room.width = 1e5;
  for (int i = 0; i <= core::kMostWeights; ++i) scene.weights.push_back(freeWeight(1 + 0.1 * i, 1));
  scene.solvers.resize(5);
  const std::vector<Problem> problems = core::problemsIn(scene);
  QCOMPARE(places(scene), QStringList({"weights", "solvers"}));
  for (const Problem& problem : problems) QCOMPARE(problem.kind, Problem::Kind::kTooMany);
  QCOMPARE(problems[0].value, 100001.0);
  QCOMPARE(problems[0].allowed.highest, 100000.0);
  QCOMPARE(problems[1].value, 5.0);
  QCOMPARE(problems[1].allowed.highest, 4.0);
  scene.weights.pop_back();
  scene.solvers.pop_back();
  QCOMPARE(places(scene), QStringList());
}

void SceneLimitsTest::writesNumbersAsAPersonWould_data() {
  QTest::addColumn<double>("value");
  QTest::addColumn<QString>("text");
  QTest::newRow("zero") << 0.0 << "0";
  QTest::newRow("negative zero") << -0.0 << "0";
  QTest::newRow("whole") << -42.0 << "-42";
  QTest::newRow("tenth") << 0.1 << "0.1";
  QTest::newRow("sixtieth") << 1.0 / 60 << "0.016666666666666666";
  QTest::newRow("smallest plain") << 1e-4 << "0.0001";
  QTest::newRow("small") << 9.5e-5 << "9.5e-5";
  QTest::newRow("smaller") << -1e-14 << "-1e-14";
  QTest::newRow("largest plain") << 9999999.5 << "9999999.5";
  QTest::newRow("large") << 1e7 << "1e7";
  QTest::newRow("larger") << 1.25e100 << "1.25e100";
  QTest::newRow("infinite") << -kInfinity << "-inf";
}

void SceneLimitsTest::writesNumbersAsAPersonWould() {
  QFETCH(double, value);
  QFETCH(QString, text);
  QCOMPARE(QString::fromStdString(core::numberText(value)), text);
}

QTEST_APPLESS_MAIN(SceneLimitsTest)
#include "scene_limits_test.moc"
