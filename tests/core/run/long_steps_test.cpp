#include <algorithm>
#include <memory>

#include <QtTest>

#include "core/run/run.h"
#include "tests/support/random_scene.h"
#include "tests/support/run_watch.h"

using core::Run;
using core::RunStatus;
using core::Scene;

namespace {

/// Twelve weights, whose ropes are never cut.
std::shared_ptr<const Scene> uncutScene(int seed) {
  Scene scene = tests::randomScene(seed, 12);
  scene.cutTime.reset();
  return std::make_shared<const Scene>(std::move(scene));
}

}  // namespace

/// Steps so long that a method's paths have little to do with where weights would go. Events
/// still come one after another, and the room holds.
class LongStepsTest : public QObject {
  Q_OBJECT

 private slots:
  void comeToTheirEnd_data();
  void comeToTheirEnd();
  void neverLeadThroughAWall_data();
  void neverLeadThroughAWall();
};

void LongStepsTest::comeToTheirEnd_data() {
  QTest::addColumn<QByteArray>("method");
  QTest::addColumn<double>("step");
  QTest::addColumn<int>("seed");
  const auto add = [](const char* what, const char* method, double step, int seed) {
    QTest::newRow(what) << QByteArray(method) << step << seed;
  };
  add("a slack rope's way back to its circle", "semi-implicit-euler", 1, 22);
  add("the same in another scene", "semi-implicit-euler", 1, 46);
  add("a rope taut without a pull", "rk4", 1, 17);
  add("a turning point at the start of a piece", "semi-implicit-euler", 0.1, 260);
  add("the same on a straight path", "euler", 0.1, 233);
  add("the same in a longer step", "euler", 0.4, 9);
}

void LongStepsTest::comeToTheirEnd() {
  QFETCH(QByteArray, method);
  QFETCH(double, step);
  QFETCH(int, seed);
  Run run(uncutScene(seed), {.method = method.toStdString(), .step = step});
  while (run.time() < 3) {
    QCOMPARE(run.advance(), RunStatus::kRunning);
    // Hundreds, where thousands of the same moment were listed once.
    QVERIFY2(run.stepEvents().size() < 20'000, qPrintable(QString::number(run.time())));
  }
}

void LongStepsTest::neverLeadThroughAWall_data() {
  QTest::addColumn<QByteArray>("method");
  QTest::addColumn<int>("seed");
  QTest::addColumn<int>("weights");
  // Polishing moves the moment at which a rope goes taut to after that at the floor.
  QTest::newRow("taut after the floor") << QByteArray("semi-implicit-euler") << 1728 << 1;
  // The method's own steps to moments inside lead elsewhere than its path.
  QTest::newRow("a step beside the path") << QByteArray("rk4") << 1735 << 8;
  QTest::newRow("a turning point outside") << QByteArray("rk4") << 5410 << 11;
}

void LongStepsTest::neverLeadThroughAWall() {
  QFETCH(QByteArray, method);
  QFETCH(int, seed);
  QFETCH(int, weights);
  Run run(std::make_shared<const Scene>(tests::randomScene(seed, weights)),
          {.method = method.toStdString(), .step = 1});
  const tests::Bounds bounds = tests::Bounds::ordinary();
  while (run.time() < 3 && run.advance() == RunStatus::kRunning) {
    const double outside = tests::farthestOutside(run, bounds);
    QVERIFY2(outside <= bounds.outside, qPrintable(QString::number(outside)));
  }
}

QTEST_APPLESS_MAIN(LongStepsTest)
#include "long_steps_test.moc"
