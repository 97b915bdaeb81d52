#include "ui/files/lessons.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <QtTest>

#include "core/run/run.h"
#include "tests/support/played_lesson.h"
#include "ui/files/scene_file.h"

using core::Event;
using core::EventKind;
using core::Run;
using Played = tests::PlayedLesson;

namespace {

/// Largest distance of the first weight in this run from the first run, up to `until` [m].
double farthestFromFirst(const char* name, std::size_t solver, double until) {
  Played exact(name), compared(name, solver);
  double farthest = 0;
  compared.play(until, [&](const Run& run) {
    exact.play(run.time() - 1e-9);
    const Eigen::Vector2d place = exact.run().weightAt(0, run.time()).position;
    farthest = std::max(farthest, (run.weight(0).position - place).norm());
  });
  return farthest;
}

}  // namespace

class LessonsTest : public QObject {
  Q_OBJECT

 private slots:
  void saysWhatTheSceneFileSays();
  void knowsALessonByItsTexts();
  void hasALessonForEveryTopic();
  void everySceneRuns();
  void eulerThrowsThePendulumOverTheTop();
  void oneEulerKeepsTheEnergyTheOtherDoesNot();
  void halfTheStepHalvesTheError();
  void onlyTheLargestStepDiverges();
  void wideSwingsTakeLonger();
  void theRopeGoesSlackAndJerksTheRodGoesRound();
  void airShortensTheThrow();
  void lightBallsReachTerminalVelocity();
  void infinitelyManyBouncesEnd();
  void onlyTheLastWeightFliesOff();
  void countsPi_data();
  void countsPi();
  void pendulumsAHairApartFanOut();
  void thePileComesToRest();
  void theReportsScenesShowWhatTheySay();
};

void LessonsTest::saysWhatTheSceneFileSays() {
  for (const ui::Lesson& lesson : ui::lessons()) {
    const core::Scene scene = ui::builtInScene(lesson.name);
    QCOMPARE(lesson.title, QString::fromStdString(scene.name));
    QCOMPARE(lesson.look, QString::fromStdString(scene.description));
    QVERIFY(lesson.tries.size() >= 2 && lesson.tries.size() <= 3);
    for (const QString& words : lesson.tries) {
      QVERIFY2(words.endsWith('.') || words.endsWith('?'), qPrintable(words));
      // Three lines of the panel at most.
      QVERIFY2(words.size() <= 110, qPrintable(words));
    }
  }
}

void LessonsTest::knowsALessonByItsTexts() {
  core::Scene scene = ui::builtInScene("pile");
  scene.gravity = 1.62;
  QCOMPARE(ui::lessonNameOf(scene), QString("pile"));
  scene.description = "My own words.";
  QCOMPARE(ui::lessonNameOf(scene), QString());
  QCOMPARE(ui::lessonNameOf(core::Scene()), QString());
  QCOMPARE(ui::lessonNamed("pile").title, QString("A pile comes to rest"));
}

void LessonsTest::hasALessonForEveryTopic() {
  const QStringList names = ui::builtInScenes();

  for (const char* topic :
       {"euler-gains-energy", "step-too-large", "terminal-velocity", "bouncing-ball",
        "newtons-cradle", "counting-pi", "slack-rope", "thousand-pendulums", "pile"})
    QVERIFY2(names.contains(topic), topic);
}

void LessonsTest::everySceneRuns() {
  for (const QString& name : ui::builtInScenes()) {
    const auto scene = std::make_shared<const core::Scene>(ui::builtInScene(name));
    QVERIFY(!scene->solvers.empty());
    Run run(scene, scene->solvers.front());
    while (run.time() < 1) QCOMPARE(run.advance(), core::RunStatus::kRunning);
  }
}

void LessonsTest::eulerThrowsThePendulumOverTheTop() {
  Played rk4("euler-gains-energy"), euler("euler-gains-energy", 1);
  rk4.play(8);
  // Of 2.8 J; a length of 1.2 m at 1/30 s leaves Runge–Kutta 4 with 10⁻⁵ of it.
  QVERIFY(std::abs(rk4.energyShare() - 1) < 1e-4);
  euler.play(8);
  const core::Rope& rope = *euler.scene().weights[0].rope;
  const double atTheTop =
      euler.scene().weights[0].mass * euler.scene().gravity * (rope.pivot.y() + rope.length);
  QVERIFY(euler.run().energies().mechanical() > atTheTop);
}

void LessonsTest::oneEulerKeepsTheEnergyTheOtherDoesNot() {
  Played semiImplicit("two-kinds-of-euler"), euler("two-kinds-of-euler", 1);
  double highest = 0, lowest = 2;
  semiImplicit.play(60, [&](const Run&) {
    highest = std::max(highest, semiImplicit.energyShare());
    lowest = std::min(lowest, semiImplicit.energyShare());
  });
  // It swings round the right value by about h ω / 2 of what moves: some percent, for ever.
  QVERIFY(highest < 1.15 && lowest > 0.85);
  QVERIFY(highest - lowest > 0.02);
  euler.play(10);
  QVERIFY(euler.energyShare() > 2);
}

void LessonsTest::halfTheStepHalvesTheError() {
  const double whole = farthestFromFirst("half-the-step", 1, 2);
  const double half = farthestFromFirst("half-the-step", 2, 2);
  const double rk4 = farthestFromFirst("half-the-step", 3, 2);
  // Order 1, seen at steps that are not small yet.
  QVERIFY2(whole / half > 1.7 && whole / half < 2.4, qPrintable(QString::number(whole / half)));
  QVERIFY(rk4 < half / 50 && rk4 > 0);
}

void LessonsTest::onlyTheLargestStepDiverges() {
  for (std::size_t solver = 0; solver < 3; ++solver) {
    Played balloon("step-too-large", solver);
    balloon.play(2);
    const bool diverged = balloon.run().status() == core::RunStatus::kDiverged;
    QCOMPARE(diverged, solver == 2);
    if (diverged) QVERIFY(balloon.run().stepCount() >= 4);  // enough to watch them grow
  }
}

void LessonsTest::wideSwingsTakeLonger() {
  Played swings("small-and-large-swings");
  swings.play(3);
  const std::vector<core::Weight>& weights = swings.scene().weights;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const core::Rope& rope = *weights[i].rope;
    // Half a period, by the complete elliptic integral of the first kind.
    const double exact = 2 * std::sqrt(rope.length / swings.scene().gravity) *
                         std::comp_ellint_1(std::sin(rope.angle / 2));
    const double seen = swings.first(EventKind::kTurningPoint, static_cast<int>(i)).time;
    // Runge–Kutta 4 at 1/60 s is right within 10⁻⁴ s here.
    QVERIFY2(std::abs(seen - exact) < 1e-3, qPrintable(QString::number(seen - exact)));
  }
}

void LessonsTest::theRopeGoesSlackAndJerksTheRodGoesRound() {
  Played both("slack-rope");
  double farthestTurn = 0;
  both.play(3, [&](const Run& run) {
    farthestTurn = std::max(farthestTurn, std::abs(run.weight(0).angle));
  });
  QVERIFY(farthestTurn > 3.2);  // beyond π: over the top
  QVERIFY(both.first(EventKind::kSlack, 1).time < both.first(EventKind::kTaut, 1).time);
  QVERIFY(both.first(EventKind::kTaut, 1).energyLost > 1);  // J, of 4.4
  QCOMPARE(both.count(EventKind::kSlack), 1);
}

void LessonsTest::airShortensTheThrow() {
  Played both("throw-in-air");
  both.play(1.6);
  const double inAir = both.first(EventKind::kImpactFloor, 0).position.x();
  const double inVacuum = both.first(EventKind::kImpactFloor, 1).position.x();
  QVERIFY(inAir < 0.5 * inVacuum);
  QCOMPARE(both.count(EventKind::kImpactWeight), 0);
}

void LessonsTest::lightBallsReachTerminalVelocity() {
  Played balls("terminal-velocity");
  balls.play(1.8);
  const core::Scene& scene = balls.scene();
  for (const int ball : {0, 1}) {
    const core::Weight& weight = scene.weights[static_cast<std::size_t>(ball)];
    const double area = std::acos(-1) * weight.radius * weight.radius;
    const double terminal = std::sqrt(2 * weight.mass * scene.gravity /
                                      (scene.airDensity * weight.dragCoefficient * area));
    const double share = balls.run().weight(ball).velocity.norm() / terminal;
    QVERIFY2(share > 0.99 && share < 1, qPrintable(QString::number(share)));
  }
  // The heavy one is down before that, and first.
  QCOMPARE(std::ranges::find(balls.events(), EventKind::kImpactFloor, &Event::kind)->weight, 2);
}

void LessonsTest::infinitelyManyBouncesEnd() {
  Played ball("bouncing-ball");
  ball.play(6);
  const core::Weight& weight = ball.scene().weights[0];
  const double e = ball.scene().room.restitution;
  const double fall = std::sqrt(2 * (weight.position.y() - weight.radius) / ball.scene().gravity);
  const double end = fall * (1 + e) / (1 - e);
  QVERIFY(end < 6);  // as the text says
  // What is left out after the last bounce that counts lasts under a millisecond.
  QVERIFY(std::abs(ball.first(EventKind::kRest, 0).time - end) < 1e-3);
  QVERIFY(ball.count(EventKind::kImpactFloor) > 30);
}

void LessonsTest::onlyTheLastWeightFliesOff() {
  Played cradle("newtons-cradle");
  double inner = 0, last = 0;
  cradle.play(10, [&](const Run& run) {
    for (int i = 1; i <= 3; ++i) inner = std::max(inner, std::abs(run.weight(i).angle));
    last = std::max(last, run.weight(4).angle);
  });
  const double start = std::abs(cradle.scene().weights[0].rope->angle);
  QVERIFY(std::abs(last - start) < 0.01 * start);
  QVERIFY(inner < 0.01 * start);
}

void LessonsTest::countsPi_data() {
  QTest::addColumn<double>("massRatio");
  QTest::addColumn<int>("impacts");
  QTest::newRow("as it opens") << 100.0 << 31;
  QTest::newRow("as the text says to try") << 10000.0 << 314;
}

void LessonsTest::countsPi() {
  QFETCH(double, massRatio);
  QFETCH(int, impacts);
  core::Scene scene = ui::builtInScene("counting-pi");
  scene.weights[1].mass = massRatio * scene.weights[0].mass;
  Run run(std::make_shared<const core::Scene>(scene), scene.solvers[0]);
  int counted = 0;
  bool atRightWall = false;
  while (!atRightWall && run.time() < 60) {
    QCOMPARE(run.advance(), core::RunStatus::kRunning);
    for (const Event& event : run.stepEvents()) {
      atRightWall |= event.kind == EventKind::kImpactEast;
      if (!atRightWall) ++counted;
    }
  }
  QVERIFY(atRightWall);
  QCOMPARE(counted, impacts);
}

void LessonsTest::pendulumsAHairApartFanOut() {
  Played pendulums("thousand-pendulums");
  const std::vector<core::Weight>& weights = pendulums.scene().weights;
  QCOMPARE(weights.size(), std::size_t{1000});
  for (std::size_t i = 1; i < weights.size(); ++i) {
    QVERIFY(std::abs(weights[i].rope->length - weights[i - 1].rope->length - 0.001) < 1e-9);
    QCOMPARE(weights[i].rope->angle, weights[0].rope->angle);
  }
  const auto spread = [&] {
    double lowest = 10, highest = -10;
    for (int i = 0; i < 1000; ++i) {
      lowest = std::min(lowest, pendulums.run().weight(i).angle);
      highest = std::max(highest, pendulums.run().weight(i).angle);
    }
    return highest - lowest;
  };
  QCOMPARE(spread(), 0.0);
  pendulums.play(3);
  QVERIFY(spread() > 3);  // rad, of 4.7 from one turning point to the other
  QCOMPARE(pendulums.count(EventKind::kImpactWeight), 0);
}

void LessonsTest::thePileComesToRest() {
  Played pile("pile");
  QVERIFY(pile.scene().weights.size() >= 30);
  pile.play(6);
  for (int i = 0; i < pile.run().weightCount(); ++i)
    QCOMPARE(pile.run().weight(i).phase, core::Phase::kResting);
  QCOMPARE(pile.run().energies().kinetic, 0.0);
  QVERIFY(pile.run().energies().lostToImpacts > 50);  // J, of 223
}

void LessonsTest::theReportsScenesShowWhatTheySay() {
  Played euler("one-pendulum", 1);
  euler.play(1.8);
  QVERIFY(euler.energyShare() > 1.01);
  Played two("two-weights");
  two.play(2);
  const Event& impact = two.first(EventKind::kImpactWeight, 0);
  QVERIFY(impact.speedAfter > impact.speedBefore);
  Played three("three-pendulums");
  three.play(2.9);
  QVERIFY(three.first(EventKind::kTurningPoint, 0).time <
          three.first(EventKind::kTurningPoint, 1).time);
  QVERIFY(three.first(EventKind::kTurningPoint, 1).time <
          three.first(EventKind::kTurningPoint, 2).time);
  Played seven("seven-weights");
  seven.play(4);
  QVERIFY(seven.count(EventKind::kImpactWeight) > 0 && seven.count(EventKind::kImpactFloor) > 0);
}

QTEST_GUILESS_MAIN(LessonsTest)
#include "lessons_test.moc"
