#include "ui/panels/timeline.h"

#include <QHelpEvent>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>

#include "core/scene/arrangement.h"
#include "ui/control/event_navigator.h"
#include "ui/control/run_controller.h"

using ui::EventNavigator;
using ui::RunController;
using ui::Timeline;

namespace {

/// Three weights that swing, are cut at 1 s, and fall.
std::shared_ptr<core::Scene> cutScene() {
  core::Scene scene = core::withWeightCount(core::Scene(), 3);
  for (core::Weight& weight : scene.weights) weight.rope->angle = 0.5;
  scene.cutTime = 1;
  scene.solvers = {{.method = "rk4"}, {.method = "euler"}};
  return std::make_shared<core::Scene>(scene);
}

/// A timeline over two recorded seconds.
struct Recorded {
  RunController controller{[] { return 0.0; }};
  EventNavigator events{&controller};
  Timeline timeline{&controller, &events};

  Recorded() {
    controller.setScene(cutScene());
    timeline.resize(800, timeline.sizeHint().height());
    controller.goTo(2);
  }

  QPoint at(double time) const {
    return {static_cast<int>(std::lround(timeline.positionOf(time))), timeline.height() / 2};
  }
  /// What one pixel stands for [s].
  double pixel() const { return 1 / (timeline.positionOf(1) - timeline.positionOf(0)); }
};

}  // namespace

class TimelineTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void showsThePressedMoment();
  void scrubsBothWays();
  void showsTheEventWhoseSignIsPressed();
  void standsStillWhileItIsDragged();
  void staysWithinTheRecord();
  void tellsWhatLiesThere();
  void drawsSignsWhereEventsAre();
};

void TimelineTest::showsThePressedMoment() {
  Recorded recorded;
  QTest::mouseClick(&recorded.timeline, Qt::LeftButton, {}, recorded.at(0.6));
  QVERIFY(std::abs(recorded.controller.time() - 0.6) < recorded.pixel());
}

void TimelineTest::scrubsBothWays() {
  Recorded recorded;
  QTest::mousePress(&recorded.timeline, Qt::LeftButton, {}, recorded.at(1.5));
  for (const double time : {0.9, 0.2, 0.7, 1.8}) {
    QTest::mouseMove(&recorded.timeline, recorded.at(time));
    QVERIFY(std::abs(recorded.controller.time() - time) < recorded.pixel());
  }
  QTest::mouseRelease(&recorded.timeline, Qt::LeftButton, {}, recorded.at(1.8));
  QTest::mouseMove(&recorded.timeline, recorded.at(0.2));
  QVERIFY(std::abs(recorded.controller.time() - 1.8) < recorded.pixel());
}

void TimelineTest::showsTheEventWhoseSignIsPressed() {
  Recorded recorded;
  QTest::mouseClick(&recorded.timeline, Qt::LeftButton, {}, recorded.at(1) + QPoint(4, 0));
  QCOMPARE(recorded.controller.time(), 1.0);
  QTest::mouseClick(&recorded.timeline, Qt::LeftButton, {}, recorded.at(1) + QPoint(9, 0));
  QVERIFY(recorded.controller.time() > 1 + 8 * recorded.pixel());
}

void TimelineTest::standsStillWhileItIsDragged() {
  Recorded recorded;
  recorded.controller.play();
  QTest::mousePress(&recorded.timeline, Qt::LeftButton, {}, recorded.at(0.5));
  const double held = recorded.controller.time();
  recorded.controller.passTime(0.1);
  QCOMPARE(recorded.controller.time(), held);
  QTest::mouseRelease(&recorded.timeline, Qt::LeftButton, {}, recorded.at(0.5));
  QVERIFY(recorded.controller.isPlaying());
  recorded.controller.passTime(0.1);
  QCOMPARE(recorded.controller.time(), held + 0.1);
}

void TimelineTest::staysWithinTheRecord() {
  Recorded recorded;
  QTest::mousePress(&recorded.timeline, Qt::LeftButton, {}, recorded.at(1.5));
  QTest::mouseMove(&recorded.timeline, QPoint(799, 5));
  QCOMPARE(recorded.controller.time(), recorded.controller.recordedUntil());
  QTest::mouseMove(&recorded.timeline, QPoint(0, 5));
  QCOMPARE(recorded.controller.time(), 0.0);
}

void TimelineTest::tellsWhatLiesThere() {
  Recorded recorded;
  QCOMPARE(recorded.timeline.wordsAt(recorded.at(1)), QString("1.000 s: Cut, weight: all"));
  const QString between = recorded.timeline.wordsAt(recorded.at(0.1));
  QVERIFY2(between.startsWith("0.10") || between.startsWith("0.09"), qPrintable(between));
  const QPoint place = recorded.at(1);
  QHelpEvent help(QEvent::ToolTip, place, recorded.timeline.mapToGlobal(place));
  QCoreApplication::sendEvent(&recorded.timeline, &help);
  QCOMPARE(QToolTip::text(), recorded.timeline.wordsAt(place));
}

void TimelineTest::drawsSignsWhereEventsAre() {
  Recorded recorded;
  recorded.controller.showTime(0);
  const QImage drawn = recorded.timeline.grab().toImage();
  for (const core::Event& event : recorded.events.log().events()) {
    // The line is there anyway; above and below it only signs are.
    if (event.kind == core::EventKind::kCut) continue;
    const QPointF place(recorded.timeline.positionOf(event.time),
                        recorded.timeline.rowOf(event.kind));
    QSet<QRgb> colors;
    for (int dx = -6; dx <= 6; ++dx) colors << drawn.pixel((place + QPointF(dx, 0)).toPoint());
    QVERIFY(colors.size() > 1);
  }
  QVERIFY(recorded.events.log().events().size() > 3);
}

QTEST_MAIN(TimelineTest)
#include "timeline_test.moc"
