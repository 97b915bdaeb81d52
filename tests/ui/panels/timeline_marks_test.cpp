#include "ui/panels/timeline_marks.h"

#include <QTest>

using core::Event;
using core::EventKind;
using ui::timelineMarks;

class TimelineMarksTest : public QObject {
  Q_OBJECT

 private slots:
  void marksEveryEventThatHasRoom();
  void thinsEachKindByItself();
  void keepsItsChoiceWhenMoreHappens();
  void isBoundedForThousandsOfEvents();

 private:
  static Event at(double time, EventKind kind) {
    Event event;
    event.time = time;
    event.kind = kind;
    return event;
  }
};

void TimelineMarksTest::marksEveryEventThatHasRoom() {
  const std::vector<Event> events{at(0.5, EventKind::kCut), at(1.5, EventKind::kCut),
                                  at(2.5, EventKind::kImpactFloor)};
  const auto marks = timelineMarks(events, 1);
  QCOMPARE(marks.size(), std::size_t{3});
  QCOMPARE(marks[1].time, 1.5);
  QCOMPARE(marks[2].kind, EventKind::kImpactFloor);
  QVERIFY(timelineMarks({}, 1).empty());
}

void TimelineMarksTest::thinsEachKindByItself() {
  const std::vector<Event> events{at(1, EventKind::kImpactFloor), at(1.1, EventKind::kImpactEast),
                                  at(1.2, EventKind::kImpactFloor),
                                  at(1.9, EventKind::kImpactFloor), at(2, EventKind::kImpactFloor)};
  const auto marks = timelineMarks(events, 1);
  const std::vector<ui::TimelineMark> expected{
      {EventKind::kImpactFloor, 1}, {EventKind::kImpactEast, 1.1}, {EventKind::kImpactFloor, 2}};
  QVERIFY(marks == expected);
}

void TimelineMarksTest::keepsItsChoiceWhenMoreHappens() {
  std::vector<Event> events;
  std::vector<ui::TimelineMark> before;
  for (int i = 0; i < 200; ++i) {
    events.push_back(at(0.037 * i, i % 3 ? EventKind::kTurningPoint : EventKind::kTaut));
    const auto marks = timelineMarks(events, 0.5);
    QVERIFY(marks.size() >= before.size());
    QVERIFY(std::equal(before.begin(), before.end(), marks.begin()));
    before = marks;
  }
}

void TimelineMarksTest::isBoundedForThousandsOfEvents() {
  std::vector<Event> events;
  for (int i = 0; i < 100000; ++i) events.push_back(at(i * 1e-4, EventKind::kImpactWeight));
  const auto marks = timelineMarks(events, 0.1);
  // Ten seconds at a tenth: none wasted and none too many.
  QVERIFY(95 <= marks.size() && marks.size() <= 100);
}

QTEST_APPLESS_MAIN(TimelineMarksTest)
#include "timeline_marks_test.moc"
