#include "ui/panels/event_table.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

using core::Event;
using core::EventKind;
using core::EventLog;
using ui::EventGroup;
using ui::EventTable;

namespace {

/// At i seconds each: impacts on the floor and of two weights in turn, of four weights.
std::vector<Event> events(int count, int first = 0) {
  std::vector<Event> events(count);
  for (int i = 0; i < count; ++i) {
    const int number = first + i;
    Event& event = events[i];
    event.time = number;
    event.weight = number % 4;
    event.kind = number % 2 ? EventKind::kImpactWeight : EventKind::kImpactFloor;
    event.other = number % 2 ? 2 : -1;
    event.speedBefore = 3;
    event.speedAfter = 2.5;
    event.energyLost = 0.25;
  }
  return events;
}

Event cutOfAll(double time) {
  Event event;
  event.time = time;
  return event;
}

QStringList row(const EventTable& table, int row) {
  QStringList texts;
  for (int column = 0; column < table.columnCount(); ++column)
    texts << table.data(table.index(row, column), Qt::DisplayRole).toString();
  return texts;
}

}  // namespace

class EventTableTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void showsWhatHappenedInWords();
  void addsWhatIsNew();
  void listsAnewWhatWasForgotten();
  void filtersByKindAndWeight_data();
  void filtersByKindAndWeight();
  void findsTheRowOfAMoment();
  void writesChosenRowsAsCsv();
  void addsToManyRowsWithoutListingThemAnew();
};

void EventTableTest::showsWhatHappenedInWords() {
  EventLog log;
  log.append(events(2));
  const Event cut = cutOfAll(1.5);
  log.append({&cut, 1});
  EventTable table;
  const QAbstractItemModelTester tester(&table);
  table.setLog(&log);
  QCOMPARE(table.rowCount(), 3);
  // Weights are counted from 1.
  QCOMPARE(row(table, 0),
           QStringList({"0.0000", "Impact on the floor", "1", "3.00", "2.50", "0.250"}));
  QCOMPARE(row(table, 1),
           QStringList({"1.0000", "Impact of weights", "2 and 3", "3.00", "2.50", "0.250"}));
  QCOMPARE(row(table, 2), QStringList({"1.5000", "Cut", "all", "", "", "0"}));
}

void EventTableTest::addsWhatIsNew() {
  EventLog log;
  EventTable table;
  const QAbstractItemModelTester tester(&table);
  table.setLog(&log);
  QSignalSpy inserted(&table, &EventTable::rowsInserted);
  QSignalSpy reset(&table, &EventTable::modelReset);
  log.append(events(10));
  table.refresh();
  log.append(events(5, 10));
  table.refresh();
  table.refresh();
  QCOMPARE(table.rowCount(), 15);
  QCOMPARE(inserted.count(), 2);
  QCOMPARE(reset.count(), 0);
  QCOMPARE(table.eventAt(14).time, 14.0);
}

void EventTableTest::listsAnewWhatWasForgotten() {
  EventLog log(20);
  EventTable table;
  const QAbstractItemModelTester tester(&table);
  table.setLog(&log);
  log.append(events(20));
  table.refresh();
  // The oldest half goes.
  log.append(events(1, 20));
  table.refresh();
  QCOMPARE(table.rowCount(), 10);
  QCOMPARE(table.eventAt(0).time, 11.0);
  // Another future, as long as the one before.
  log.dropFrom(18);
  const std::vector<Event> others{cutOfAll(18), cutOfAll(18.5), cutOfAll(19)};
  log.append(others);
  table.refresh();
  QCOMPARE(table.rowCount(), 10);
  QCOMPARE(table.eventAt(9).kind, EventKind::kCut);
}

void EventTableTest::filtersByKindAndWeight_data() {
  QTest::addColumn<EventGroup>("group");
  QTest::addColumn<int>("weight");
  QTest::addColumn<QList<double>>("times");
  using Times = QList<double>;
  QTest::newRow("everything") << EventGroup::kAll << -1 << Times{0, 1, 2, 3, 4, 5, 6, 7, 8};
  QTest::newRow("impacts") << EventGroup::kImpacts << -1 << Times{0, 1, 2, 3, 4, 5, 6, 7};
  QTest::newRow("cuts") << EventGroup::kCuts << -1 << Times{8};
  QTest::newRow("ropes") << EventGroup::kRopes << -1 << Times{};
  // The cut of all concerns each; weight 2 is also hit by others.
  QTest::newRow("weight 0") << EventGroup::kAll << 0 << Times{0, 4, 8};
  QTest::newRow("weight 2") << EventGroup::kAll << 2 << Times{1, 2, 3, 5, 6, 7, 8};
  QTest::newRow("impacts of weight 2") << EventGroup::kImpacts << 2 << Times{1, 2, 3, 5, 6, 7};
}

void EventTableTest::filtersByKindAndWeight() {
  QFETCH(EventGroup, group);
  QFETCH(int, weight);
  QFETCH(QList<double>, times);
  EventLog log;
  EventTable table;
  table.setLog(&log);
  table.setFilter(group, weight);
  log.append(events(8));
  const Event cut = cutOfAll(8);
  log.append({&cut, 1});
  table.refresh();
  QList<double> listed;
  for (int i = 0; i < table.rowCount(); ++i) listed << table.eventAt(i).time;
  QCOMPARE(listed, times);
}

void EventTableTest::findsTheRowOfAMoment() {
  EventLog log;
  log.append(events(10));
  EventTable table;
  table.setLog(&log);
  QCOMPARE(table.rowAt(-0.5), -1);
  QCOMPARE(table.rowAt(0), 0);
  QCOMPARE(table.rowAt(3.5), 3);
  QCOMPARE(table.rowAt(100), 9);
  table.setFilter(EventGroup::kAll, 3);  // those of 3 s and 7 s
  QCOMPARE(table.rowAt(6.9), 0);
  QCOMPARE(table.rowAt(7), 1);
}

void EventTableTest::writesChosenRowsAsCsv() {
  EventLog log;
  log.append(events(4));
  EventTable table;
  table.setLog(&log);
  const std::vector<int> rows{1, 3};
  QCOMPARE(table.csv(rows), std::string("time,event,weight,other,x,y,energy_lost\r\n"
                                        "1,impact-weight,1,2,0,0,0.25\r\n"
                                        "3,impact-weight,3,2,0,0,0.25\r\n"));
}

void EventTableTest::addsToManyRowsWithoutListingThemAnew() {
  EventLog log;
  log.append(events(100000));
  EventTable table;
  table.setLog(&log);
  QCOMPARE(table.rowCount(), 100000);
  QCOMPARE(row(table, 99999).first(), QString("99999.0000"));
  // New events cost what they are, not what is there already.
  QSignalSpy reset(&table, &EventTable::modelReset);
  for (int i = 0; i < 1000; ++i) {
    log.append(events(1, 100000 + i));
    table.refresh();
  }
  QCOMPARE(table.rowCount(), 101000);
  QCOMPARE(reset.count(), 0);
}

QTEST_MAIN(EventTableTest)
#include "event_table_test.moc"
