// The soak in short. Where memory is compared, the start is left out: tables and caches fill up.

#include <cmath>
#include <vector>

#include <QApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/soak/long_run.h"
#include "tests/soak/window_day.h"
#include "tests/support/crowded_file.h"

class SoakTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void longRunsStayAsTheyAre_data();
  void longRunsStayAsTheyAre();
  void rowsStream();
  void aCrowdStreams();
  void theWindowDoesNotGrow();
};

void SoakTest::initTestCase() {
  // The address sanitizer keeps what is given back, which looks like growth.
  qputenv("ASAN_OPTIONS", qgetenv("ASAN_OPTIONS") + ":quarantine_size_mb=1");
}

void SoakTest::longRunsStayAsTheyAre_data() {
  using ScenePointer = std::shared_ptr<const core::Scene>;
  QTest::addColumn<ScenePointer>("scene");
  QTest::addColumn<bool>("isRecorded");
  QTest::addColumn<double>("mostDrift");
  for (const bool isRecorded : {false, true}) {
    const char* history = isRecorded ? "recorded" : "not recorded";
    // What the swing before the cut costs; nothing comes after it.
    QTest::addRow("seven that never rest, %s", history)
        << sevenThatNeverRest() << isRecorded << 1e-7;
    // What the coming to rest costs.
    QTest::addRow("heap, %s", history) << pileThatRests() << isRecorded << 1e-2;
  }
}

void SoakTest::longRunsStayAsTheyAre() {
  QFETCH(std::shared_ptr<const core::Scene>, scene);
  QFETCH(bool, isRecorded);
  QFETCH(double, mostDrift);
  std::vector<LongRunFigures> figures;
  runLong(scene, 300, 60, isRecorded, [&](const LongRunFigures& now) { figures.push_back(now); });
  QCOMPARE(figures.size(), std::size_t{6});
  const LongRunFigures& early = figures[2];
  const LongRunFigures& late = figures.back();
  QVERIFY2(std::abs(late.drift) < mostDrift, qPrintable(QString::number(late.drift)));
  QVERIFY2(std::abs(late.drift - early.drift) < 1e-10,
           qPrintable(QString::number(late.drift - early.drift)));
  QVERIFY(late.overlap < 1e-6);
  QVERIFY(late.events > 100);
  // The history is on its way to its 64 MiB of states; without one nothing is asked for.
  const double growth = late.process.heapMiB - early.process.heapMiB;
  QVERIFY2(growth < (isRecorded ? 40 : 0.1), qPrintable(QString::number(growth)));
  QCOMPARE(late.process.handles, early.process.handles);
}

void SoakTest::rowsStream() {
  const auto peakOf = [](const char* until) {
    const Ended ended = runToEnd({ANGRYCUTS_PROGRAM, "simulate", "seven-weights", "--until", until,
                                  "--sample", "0.001", "--trajectory", "-"});
    return ended.status == 0 && ended.lines > 90'000 ? ended.peakMiB : -1;
  };
  const double few = peakOf("14.2857");   // 100,000 rows
  const double many = peakOf("142.857");  // a million, 100 MiB
  QVERIFY(few > 0 && many > 0);
  QVERIFY2(many < few + 4, qPrintable(QString("%1 MiB, then %2 MiB").arg(few).arg(many)));
}

void SoakTest::aCrowdStreams() {
  const QTemporaryDir folder;
  QFile file(folder.filePath("crowd.json"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(oneLineOf(20'000));
  file.close();
  const auto peakOf = [&](const char* sample) {
    const Ended ended = runToEnd({ANGRYCUTS_PROGRAM, "simulate", file.fileName().toStdString(),
                                  "--until", "0.1", "--sample", sample, "--trajectory", "-"});
    return ended.status == 0 ? ended.peakMiB : -1;
  };
  const double few = peakOf("0.1");
  const double many = peakOf("0.005");  // 420,000 rows, 30 MiB
  QVERIFY(few > 0 && many > 0);
  QVERIFY2(many < few + 8, qPrintable(QString("%1 MiB, then %2 MiB").arg(few).arg(many)));
}

void SoakTest::theWindowDoesNotGrow() {
  WindowDay day(4);
  for (int hour = 0; hour < 2; ++hour) day.spendHour(60);
  const WindowFigures before = day.figures();
  for (int hour = 0; hour < 2; ++hour) day.spendHour(60);
  const WindowFigures after = day.figures();
  QCOMPARE(after.objects, before.objects);
  QCOMPARE(after.windows, before.windows);
  QCOMPARE(after.process.handles, before.process.handles);
  QVERIFY(after.process.threads <= before.process.threads);
  const double growth = after.process.heapMiB - before.process.heapMiB;
  // Two hours open 16 scenes; their records, did they stay, would take several MiB.
  QVERIFY2(growth < 0.5, qPrintable(QString::number(growth)));
}

QTEST_MAIN(SoakTest)
#include "soak_test.moc"
