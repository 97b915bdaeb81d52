#include <memory>

#include <QTest>

#include "tests/support/fingerprint.h"
#include "tests/support/heap.h"
#include "tests/support/random_scene.h"

using core::Run;

namespace {

core::Solver solver(const char* method) {
  return {.method = method, .step = 1.0 / 60};
}

}  // namespace

class GivingUpTest : public QObject {
  Q_OBJECT

 private slots:
  void goesOnToTheSameBits_data();
  void goesOnToTheSameBits();
  void standsWhereItStood();
  void keepsCutsByHand();
  void tellsHowFarTheStepIs();
};

void GivingUpTest::goesOnToTheSameBits_data() {
  QTest::addColumn<std::shared_ptr<const core::Scene>>("scene");
  QTest::addColumn<QString>("method");
  const auto made = std::make_shared<const core::Scene>(tests::randomScene(1, 6));
  QTest::newRow("events") << made << "rk4";
  QTest::newRow("adaptive") << made << "dopri5";
  QTest::newRow("heap") << tests::pouredHeap(20, 0.5) << "rk4";
}

void GivingUpTest::goesOnToTheSameBits() {
  QFETCH(std::shared_ptr<const core::Scene>, scene);
  QFETCH(QString, method);
  Run plain(scene, solver(method.toLatin1()));
  Run broken(scene, solver(method.toLatin1()));
  int givenUp = 0;
  for (int step = 0; step < 90; ++step) {
    plain.advance();
    // At a later question each time, until the step is through before it comes.
    for (int most = step % 7;; most += 5) {
      int questions = 0;
      if (broken.tryAdvance([&](double) { return questions++ < most; })) break;
      ++givenUp;
      QCOMPARE(broken.stepCount(), step);
    }
    QCOMPARE(tests::fingerprint(broken), tests::fingerprint(plain));
  }
  QVERIFY(givenUp > 100);
}

void GivingUpTest::standsWhereItStood() {
  Run run(tests::pouredHeap(20, 0.5), solver("rk4"));
  for (int step = 0; step < 40; ++step) run.advance();
  const std::vector<double> before = tests::fingerprint(run);
  QVERIFY(run.knowsLatestStep());
  QVERIFY(!run.tryAdvance([](double) { return false; }));
  QCOMPARE(run.status(), core::RunStatus::kRunning);
  QVERIFY(!run.knowsLatestStep());
  // With the events of its latest step: a record that is cut off here still needs them.
  QCOMPARE(tests::fingerprint(run), before);
}

void GivingUpTest::keepsCutsByHand() {
  core::Scene scene = tests::randomScene(1, 6);
  scene.cutTime.reset();
  const auto shared = std::make_shared<const core::Scene>(scene);
  Run plain(shared, solver("rk4"));
  Run broken(shared, solver("rk4"));
  for (Run* run : {&plain, &broken}) run->cutAll();
  QVERIFY(!broken.tryAdvance([](double) { return false; }));
  plain.advance();
  QVERIFY(broken.tryAdvance({}));
  QVERIFY(!plain.stepEvents().empty());
  QCOMPARE(tests::fingerprint(broken), tests::fingerprint(plain));
}

void GivingUpTest::tellsHowFarTheStepIs() {
  Run run(tests::pouredHeap(20, 0.5), solver("rk4"));
  for (int step = 0; step < 60; ++step) run.advance();
  std::vector<double> shares;
  QVERIFY(run.tryAdvance([&](double share) {
    shares.push_back(share);
    return true;
  }));
  QCOMPARE(shares.front(), 0.0);
  QVERIFY(shares.back() > 0 && shares.back() <= 1);
  QVERIFY(std::is_sorted(shares.begin(), shares.end()));
}

QTEST_GUILESS_MAIN(GivingUpTest)
#include "giving_up_test.moc"
