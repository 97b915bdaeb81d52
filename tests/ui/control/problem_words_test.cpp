#include "ui/control/problem_words.h"

#include <limits>

#include <QLocale>
#include <QTest>

#include "core/scene/arrangement.h"
#include "core/scene/scene_limits.h"
#include "ui/control/translations.h"

class ProblemWordsTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QLocale::setDefault(QLocale::c()); }
  void cleanup() { ui::speak(ui::Language::kEnglish); }
  void saysWhatIsWrongAndWhere_data();
  void saysWhatIsWrongAndWhere();
  void countsFurtherProblems();
  void namesEveryQuantityInEveryLanguage_data();
  void namesEveryQuantityInEveryLanguage();
};

namespace {

using Edit = void (*)(core::Scene&);

core::Scene edited(Edit edit) {
  core::Scene scene = core::withWeightCount(core::Scene(), 2);
  edit(scene);
  return scene;
}

}  // namespace

void ProblemWordsTest::saysWhatIsWrongAndWhere_data() {
  QTest::addColumn<Edit>("edit");
  QTest::addColumn<QString>("words");
  QTest::newRow("range") << Edit([](core::Scene& scene) { scene.gravity = -1; })
                         << "Gravity must be from 0 to 1000\u00a0m/s².";
  QTest::newRow("range of a weight") << Edit([](core::Scene& scene) { scene.weights[1].mass = 0; })
                                     << "The mass (number 2) must be from 1e-6 to 1e9\u00a0kg.";
  QTest::newRow("start of a rope")
      << Edit([](core::Scene& scene) { scene.weights[0].rope->angularVelocity = 1e6; })
      << "The angular velocity (number 1) must be from -100000 to 100000\u00a0°/s.";
  QTest::newRow("start of a throw") << Edit([](core::Scene& scene) {
    scene.weights[0].rope.reset();
    scene.weights[0].position = {0.1, 0.1};
    scene.weights[0].velocity.y() = 1e6;
  }) << "The velocity y (number 1) must be from -100000 to 100000\u00a0m/s.";
  QTest::newRow("tolerance of a run") << Edit([](core::Scene& scene) {
    scene.solvers = {{"dopri5", 0.1, 2}};
  }) << "The tolerance (number 1) must be from 1e-14 to 1.";
  QTest::newRow("runs") << Edit([](core::Scene& scene) { scene.solvers.resize(5); })
                        << "There are more than 4 runs.";
  QTest::newRow("overlap") << Edit([](core::Scene& scene) {
    scene.weights[1].rope = scene.weights[0].rope;
  }) << "Weights 1 and 2 overlap at the start.";
  QTest::newRow("outside") << Edit([](core::Scene& scene) { scene.weights[1].rope->length = 5; })
                           << "Weight 2 does not start inside the room.";
  QTest::newRow("tied outside") << Edit([](core::Scene& scene) {
    scene.weights[0].rope->pivot.x() = -1;
  }) << "The rope of weight 1 is tied outside the room.";
}

void ProblemWordsTest::saysWhatIsWrongAndWhere() {
  QFETCH(Edit, edit);
  QFETCH(QString, words);
  const std::vector<core::Problem> problems = core::problemsIn(edited(edit));
  QCOMPARE(problems.size(), std::size_t{1});
  QCOMPARE(ui::problemWords(problems.front()), words);
}

void ProblemWordsTest::countsFurtherProblems() {
  const core::Scene scene = edited([](core::Scene& draft) {
    draft.gravity = -1;
    draft.airDensity = -1;
  });
  QVERIFY(ui::problemWords(core::problemsIn(scene)).startsWith("Gravity must"));
  QVERIFY(ui::problemWords(core::problemsIn(scene)).contains("1"));
}

void ProblemWordsTest::namesEveryQuantityInEveryLanguage_data() {
  QTest::addColumn<ui::Language>("language");
  for (int i = 1; i < ui::kLanguageCount; ++i) {
    const auto language = static_cast<ui::Language>(i);
    QTest::newRow(qPrintable(ui::nameOf(language))) << language;
  }
}

void ProblemWordsTest::namesEveryQuantityInEveryLanguage() {
  QFETCH(ui::Language, language);
  ui::speak(language);
  core::Scene scene = core::withWeightCount(core::Scene(), 2);
  const auto nan = std::numeric_limits<double>::quiet_NaN();
  scene.gravity = scene.airDensity = scene.restitution = nan;
  scene.cutTime = nan;
  scene.room = {nan, nan, nan, nan};
  scene.weights[0].mass = scene.weights[0].radius = scene.weights[0].dragCoefficient = nan;
  scene.weights[0].rope = core::Rope{{1, 1}, nan, nan, nan, false};
  scene.weights[1].rope.reset();
  scene.weights[1].velocity = {nan, nan};
  scene.solvers = {{"rk4", nan, nan}};
  const std::vector<core::Problem> problems = core::problemsIn(scene);
  QCOMPARE(problems.size(), std::size_t{18});
  for (const core::Problem& problem : problems) {
    // What stands behind the last point of a place is a key, which is for files alone.
    const QString key = QString::fromStdString(problem.place).section("].", -1);
    const QString words = ui::problemWords(problem);
    QVERIFY2(!words.startsWith(key), qPrintable(words));
    if (language == ui::Language::kEnglish) continue;
    ui::speak(ui::Language::kEnglish);
    QVERIFY2(words.section(' ', 0, 1) != ui::problemWords(problem).section(' ', 0, 1),
             qPrintable(words));
    ui::speak(language);
  }
}

QTEST_MAIN(ProblemWordsTest)
#include "problem_words_test.moc"
