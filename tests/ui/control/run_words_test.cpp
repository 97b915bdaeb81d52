#include "ui/control/run_words.h"

#include <QLocale>
#include <QTest>

#include "core/run/run.h"
#include "tests/support/thick_air.h"

using core::Run;
using core::RunStatus;

namespace {

/// Drag turns its speed around within 10⁻²⁰ s.
std::shared_ptr<const core::Scene> stiffest() {
  core::Scene scene = *tests::thickAir();
  scene.airDensity = 2000;
  scene.weights[0].mass = 1e-6;
  scene.weights[0].radius = 100;
  scene.weights[0].dragCoefficient = 10;
  scene.weights[0].velocity = {1e5, 0};
  return std::make_shared<const core::Scene>(std::move(scene));
}

}  // namespace

class RunWordsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void sayNothingWhileARunGoesOn();
  void sayWhenNumbersGrewBeyondAllBounds();
  void sayWhenNoStepKeepsTheTolerance();
};

void RunWordsTest::sayNothingWhileARunGoesOn() {
  Run run(tests::thickAir(), {.method = "rk4", .step = 1e-4});
  QCOMPARE(run.advance(), RunStatus::kRunning);
  QCOMPARE(ui::stopWords(run), QString());
}

void RunWordsTest::sayWhenNumbersGrewBeyondAllBounds() {
  Run run(tests::thickAir(), {.method = "euler", .step = 0.25});
  for (int i = 0; i < 100 && run.status() == RunStatus::kRunning; ++i) run.advance();
  QCOMPARE(run.status(), RunStatus::kDiverged);
  QCOMPARE(ui::stopWords(run),
           QString("Euler (explicit), 1/4 s, diverged at %1 s. Its last finite state is shown; try "
                   "a smaller step.")
               .arg(run.time(), 0, 'f', 3));
}

void RunWordsTest::sayWhenNoStepKeepsTheTolerance() {
  Run run(stiffest(), {.method = "dopri5", .tolerance = 1});
  for (int i = 0; i < 10 && run.status() == RunStatus::kRunning; ++i) run.advance();
  QCOMPARE(run.status(), RunStatus::kStalled);
  QCOMPARE(ui::stopWords(run),
           QString("Dormand–Prince 5(4), tolerance 1, stopped at 0.000 s: the tolerance asks for "
                   "more or smaller steps than can be taken."));
}

QTEST_MAIN(RunWordsTest)
#include "run_words_test.moc"
