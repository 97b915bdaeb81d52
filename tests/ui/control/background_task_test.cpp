#include "ui/control/background_task.h"

#include <memory>
#include <thread>

#include <QSignalSpy>
#include <QTest>

using ui::BackgroundTask;

class BackgroundTaskTest : public QObject {
  Q_OBJECT

 private slots:
  void worksInAnotherThreadAndSaysWhenItIsDone();
  void tellsEachPercentOnce();
  void endsEarlyWhenCancelled();
  void waitsForItsWorkInTheEnd();
  void worksAgain();
};

void BackgroundTaskTest::worksInAnotherThreadAndSaysWhenItIsDone() {
  BackgroundTask task;
  QSignalSpy running(&task, &BackgroundTask::runningChanged);
  std::thread::id worker, finisher;
  task.start([&](const core::Progress&) { worker = std::this_thread::get_id(); },
             [&] { finisher = std::this_thread::get_id(); });
  QVERIFY(task.isRunning());
  QTRY_VERIFY(!task.isRunning());
  QVERIFY(worker != std::this_thread::get_id());
  QVERIFY(finisher == std::this_thread::get_id());
  QCOMPARE(running, QList<QVariantList>({{true}, {false}}));
}

void BackgroundTaskTest::tellsEachPercentOnce() {
  BackgroundTask task;
  QSignalSpy progressed(&task, &BackgroundTask::progressed);
  task.start(
      [](const core::Progress& progress) {
        for (int i = 0; i <= 1000; ++i) progress(i / 2000.0);
      },
      [] {});
  QTRY_VERIFY(!task.isRunning());
  QCOMPARE(progressed.size(), 51);  // 0 when it starts, 1 … 50
  QCOMPARE(progressed.last().first().toInt(), 50);
}

void BackgroundTaskTest::endsEarlyWhenCancelled() {
  BackgroundTask task;
  bool isDone = false;
  task.start(
      [](const core::Progress& progress) {
        while (progress(0.5)) std::this_thread::yield();
      },
      [&] { isDone = true; });
  task.cancel();
  QTRY_VERIFY(!task.isRunning());
  QVERIFY(!isDone);
}

void BackgroundTaskTest::waitsForItsWorkInTheEnd() {
  auto hasEnded = std::make_shared<bool>(false);
  {
    BackgroundTask task;
    task.start(
        [=](const core::Progress& progress) {
          while (progress(0)) std::this_thread::yield();
          *hasEnded = true;
        },
        [] { QFAIL("nobody is there to be told"); });
  }
  QVERIFY(*hasEnded);
}

void BackgroundTaskTest::worksAgain() {
  BackgroundTask task;
  int done = 0;
  for (int i = 1; i <= 3; ++i) {
    task.start([](const core::Progress&) {}, [&] { ++done; });
    QTRY_VERIFY(!task.isRunning());
    QCOMPARE(done, i);
  }
}

QTEST_GUILESS_MAIN(BackgroundTaskTest)
#include "background_task_test.moc"
