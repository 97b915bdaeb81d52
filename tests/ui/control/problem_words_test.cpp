#include "ui/control/problem_words.h"

#include <QLocale>
#include <QTest>

#include "core/scene/arrangement.h"
#include "core/scene/scene_limits.h"

class ProblemWordsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void saysWhatIsWrongAndWhere_data();
  void saysWhatIsWrongAndWhere();
  void namesAMethodThatThereIsNot();
  void countsFurtherProblems();
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
  QTest::newRow("overlap") << Edit([](core::Scene& scene) {
    scene.weights[1].rope = scene.weights[0].rope;
  }) << "Weights 1 and 2 overlap at the start.";
  QTest::newRow("outside") << Edit([](core::Scene& scene) { scene.weights[1].rope->length = 5; })
                           << "Weight 2 does not start inside the room.";
  QTest::newRow("tied outside") << Edit([](core::Scene& scene) {
    scene.weights[0].rope->pivot.x() = -1;
  }) << "The rope of weight 1 is tied outside the room.";
  QTest::newRow("runs") << Edit([](core::Scene& scene) {
    scene.solvers.assign(core::kMostSolvers + 1, {.method = "rk4"});
  }) << "There are more than 4.";
}

void ProblemWordsTest::saysWhatIsWrongAndWhere() {
  QFETCH(Edit, edit);
  QFETCH(QString, words);
  const std::vector<core::Problem> problems = core::problemsIn(edited(edit));
  QCOMPARE(problems.size(), std::size_t{1});
  QCOMPARE(ui::problemWords(problems.front()), words);
}

// Only a file can name one.
void ProblemWordsTest::namesAMethodThatThereIsNot() {
  const core::Problem problem{
      "solvers[0].method", core::Problem::Kind::kUnknownMethod, 0, {}, -1, "guess"};
  QCOMPARE(ui::problemWords(problem), QString("There is no method named guess."));
}

void ProblemWordsTest::countsFurtherProblems() {
  const core::Scene scene = edited([](core::Scene& draft) {
    draft.gravity = -1;
    draft.airDensity = -1;
  });
  QVERIFY(ui::problemWords(core::problemsIn(scene)).startsWith("Gravity must"));
  QVERIFY(ui::problemWords(core::problemsIn(scene)).contains("1"));
}

QTEST_MAIN(ProblemWordsTest)
#include "problem_words_test.moc"
