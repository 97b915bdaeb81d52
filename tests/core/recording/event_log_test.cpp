#include "core/recording/event_log.h"

#include <utility>

#include <QtTest>

using core::Event;
using core::EventLog;

namespace {

/// Events at 0 s, 1 s, 2 s, …
std::vector<Event> eventsUpTo(int count) {
  std::vector<Event> events(count);
  for (int i = 0; i < count; ++i) events[i].time = i;
  return events;
}

}  // namespace

class EventLogTest : public QObject {
  Q_OBJECT

 private slots:
  void keepsEventsInOrder();
  void forgetsTheOldestHalfWhenFull();
  void survivesMoreAtOnceThanItHolds();
  void staysBounded();
  void dropsTheFuture();
  void startsAnew();
  void tellsForgettingFromAppending();
};

void EventLogTest::keepsEventsInOrder() {
  EventLog log;
  const std::vector<Event> events = eventsUpTo(5);
  log.append(std::span(events).first(2));
  log.append({});
  log.append(std::span(events).subspan(2));
  QCOMPARE(log.events().size(), std::size_t{5});
  QCOMPARE(log.events()[4].time, 4.0);
  QCOMPARE(log.forgotten(), std::size_t{0});
}

void EventLogTest::forgetsTheOldestHalfWhenFull() {
  EventLog log(10);
  log.append(eventsUpTo(10));
  QCOMPARE(log.forgotten(), std::size_t{0});
  Event next;
  next.time = 10;
  log.append(std::span(&next, 1));
  QCOMPARE(log.events().size(), std::size_t{5});
  QCOMPARE(log.forgotten(), std::size_t{6});
  QCOMPARE(log.events().front().time, 6.0);
  QCOMPARE(log.events().back().time, 10.0);
}

void EventLogTest::survivesMoreAtOnceThanItHolds() {
  EventLog log(4);
  log.append(eventsUpTo(1000));
  QCOMPARE(log.events().size() + log.forgotten(), std::size_t{1000});
  QCOMPARE(log.events().back().time, 999.0);
}

void EventLogTest::staysBounded() {
  EventLog log(7);
  for (const Event& event : eventsUpTo(1000)) {
    log.append(std::span(&event, 1));
    QVERIFY(log.events().size() <= 7);
    QCOMPARE(log.events().back().time, event.time);
  }
  QCOMPARE(log.events().size() + log.forgotten(), std::size_t{1000});
}

void EventLogTest::dropsTheFuture() {
  EventLog log;
  log.append(eventsUpTo(10));
  log.dropFrom(3.5);
  QCOMPARE(log.events().size(), std::size_t{4});
  log.dropFrom(3);
  QCOMPARE(log.events().back().time, 2.0);
  log.dropFrom(-1);
  QVERIFY(log.events().empty());
}

void EventLogTest::startsAnew() {
  EventLog log(4);
  log.append(eventsUpTo(9));
  log.clear();
  QVERIFY(log.events().empty());
  QCOMPARE(log.forgotten(), std::size_t{0});
}

void EventLogTest::tellsForgettingFromAppending() {
  EventLog log(10);
  std::uint64_t revision = log.revision();
  const auto hasChanged = [&] { return std::exchange(revision, log.revision()) != revision; };
  log.append(eventsUpTo(10));
  QVERIFY(!hasChanged());
  log.dropFrom(20);
  QVERIFY(!hasChanged());
  log.dropFrom(9);
  QVERIFY(hasChanged());
  log.append(eventsUpTo(10));
  QVERIFY(hasChanged());
  log.clear();
  QVERIFY(hasChanged());
}

QTEST_APPLESS_MAIN(EventLogTest)
#include "event_log_test.moc"
