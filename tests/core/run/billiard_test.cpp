#include "tests/support/billiard.h"

#include <cmath>
#include <memory>

#include <QtTest>

#include "core/run/run.h"

using core::EventKind;
using core::Run;

class BilliardTest : public QObject {
  Q_OBJECT

 private slots:
  void countsTheDigitsOfPi_data();
  void countsTheDigitsOfPi();
};

void BilliardTest::countsTheDigitsOfPi_data() {
  QTest::addColumn<QByteArray>("method");
  QTest::addColumn<double>("massRatio");
  QTest::addColumn<int>("impacts");
  for (const std::string method : {"semi-implicit-euler", "rk4", "dopri5", "reference"}) {
    const auto row = [&](const char* ratio, double massRatio, int impacts) {
      QTest::addRow("%s, %s", ratio, method.c_str())
          << QByteArray::fromStdString(method) << massRatio << impacts;
    };
    row("1", 1e0, 3);
    row("100", 1e2, 31);
    row("10⁴", 1e4, 314);
    row("10⁶", 1e6, 3141);
    row("10⁸", 1e8, 31415);
    row("10¹⁰", 1e10, 314159);
  }
}

void BilliardTest::countsTheDigitsOfPi() {
  QFETCH(QByteArray, method);
  QFETCH(double, massRatio);
  QFETCH(int, impacts);
  Run run(std::make_shared<const core::Scene>(tests::billiard(massRatio)),
          {.method = method.toStdString(), .step = 1.0 / 60});
  int counted = 0;
  while (run.time() < tests::kBilliardEnd) {
    QCOMPARE(run.advance(), core::RunStatus::kRunning);
    for (const core::Event& event : run.stepEvents())
      if (event.kind == EventKind::kImpactWeight || event.kind == EventKind::kImpactWest) ++counted;
  }
  QCOMPARE(counted, impacts);
  QVERIFY(std::abs(run.weight(1).position.x() -
                   tests::exactBilliardPlace(run.scene(), run.time())) < 1e-9);
  // Each impact rounds the light disc's energy once.
  QVERIFY(std::abs(run.energies().numericalDrift) < 1e-15 * impacts * run.startEnergy());
}

QTEST_APPLESS_MAIN(BilliardTest)
#include "billiard_test.moc"
