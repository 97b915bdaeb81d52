// Drives the window as a person does who looks things up in the list of events.
#include <algorithm>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLocale>
#include <QSettings>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/impacts.h"
#include "tests/support/shown_window.h"
#include "tests/support/swinging_scene.h"
#include "ui/control/run_controller.h"
#include "ui/main_window.h"
#include "ui/panels/events_panel.h"

using tests::isImpact;

namespace {

class Window : public tests::ShownWindow {
 public:
  Window() : ShownWindow(tests::cutSwings()) {}

  void showEvents() {
    findChild<QDockWidget*>("events")->raise();
    QApplication::processEvents();
  }
  QTableView* list() const { return findChild<ui::EventsPanel*>()->findChild<QTableView*>(); }
  QString text(int row, int column) const {
    return list()->model()->index(row, column).data().toString();
  }
  void clickRow(int row) const {
    const QModelIndex index = list()->model()->index(row, 0);
    list()->scrollTo(index);
    QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, list()->visualRect(index).center());
  }
};

}  // namespace

class EventsWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void listFollowsTheMomentShown();
  void clickOnAnEventShowsItsMoment();
  void arrowKeysInTheListGoFromEventToEvent();
  void listHasRoomForItsHeadings();
  void listsOneWeightOrKind();
  void listsTheEventsOfTheChosenRun();
  void copiesEventsAsCsv();

 private:
  QTemporaryDir m_folder;
};

void EventsWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void EventsWindowTest::listFollowsTheMomentShown() {
  Window window;
  window.controller()->goTo(3);
  window.showEvents();
  const auto events = window.controller()->recording(0).eventLog().events();
  QCOMPARE(window.list()->model()->rowCount(), static_cast<int>(events.size()));
  for (const double time : {1.1, 0.2, 1.9}) {
    window.controller()->showTime(time);
    const auto later = std::ranges::upper_bound(events, time, {}, &core::Event::time);
    const int row = static_cast<int>(later - events.begin()) - 1;
    QCOMPARE(window.list()->currentIndex().row(), row);
    if (row >= 0)
      QVERIFY(window.list()->viewport()->rect().intersects(
          window.list()->visualRect(window.list()->currentIndex())));
    // Following does not lead away from the moment.
    QCOMPARE(window.time(), time);
  }
}

void EventsWindowTest::clickOnAnEventShowsItsMoment() {
  Window window;
  window.controller()->goTo(3);
  window.showEvents();
  window.controller()->play();
  const auto events = window.controller()->recording(0).eventLog().events();
  for (const int row : {static_cast<int>(events.size()) - 1, 0}) {
    window.clickRow(row);
    QCOMPARE(window.time(), events[row].time);
    QCOMPARE(window.list()->currentIndex().row(), row);
    QVERIFY(!window.controller()->isPlaying());
  }
}

void EventsWindowTest::arrowKeysInTheListGoFromEventToEvent() {
  Window window;
  window.controller()->goTo(3);
  window.showEvents();
  window.clickRow(0);
  const auto events = window.controller()->recording(0).eventLog().events();
  for (int row = 1; row < 4; ++row) {
    QTest::keyClick(window.list(), Qt::Key_Down);
    QCOMPARE(window.time(), events[row].time);
    QCOMPARE(window.list()->currentIndex().row(), row);
  }
}

void EventsWindowTest::listHasRoomForItsHeadings() {
  Window window;
  window.showEvents();
  const QHeaderView* columns = window.list()->horizontalHeader();
  QVERIFY(columns->font().pointSizeF() >= 12);
  for (int column = 0; column < columns->count(); ++column)
    QVERIFY2(columns->sectionSize(column) >= columns->sectionSizeHint(column),
             qPrintable(QStringLiteral("%1: %2 < %3")
                            .arg(column)
                            .arg(columns->sectionSize(column))
                            .arg(columns->sectionSizeHint(column))));
}

void EventsWindowTest::listsOneWeightOrKind() {
  Window window;
  window.controller()->goTo(3);
  window.showEvents();
  auto* weight = window.findChild<QSpinBox*>("eventWeight");
  QCOMPARE(weight->maximum(), 3);
  weight->setFocus();
  weight->selectAll();
  QTest::keyClicks(weight, "2");
  QTest::keyClick(weight, Qt::Key_Return);
  const int count = window.list()->model()->rowCount();
  const auto all = window.controller()->recording(0).eventLog().events().size();
  QVERIFY(count > 0 && count < static_cast<int>(all));
  for (int row = 0; row < count; ++row) {
    const QString who = window.text(row, 2);
    QVERIFY2(who.contains('2') || who == "all", qPrintable(who));
  }
  window.findChild<ui::EventsPanel*>()->setWeight(-1);
  auto* kinds = window.findChild<QComboBox*>("eventKinds");
  kinds->setFocus();
  QTest::keyClicks(kinds, "Cuts");
  QCOMPARE(window.list()->model()->rowCount(), 1);
  QCOMPARE(window.text(0, 1), QString("Cut"));
}

void EventsWindowTest::listsTheEventsOfTheChosenRun() {
  Window window;
  window.controller()->goTo(3);
  window.showEvents();
  auto* runs = window.findChild<QComboBox*>("eventRun");
  runs->setFocus();
  QTest::keyClick(runs, Qt::Key_Down);
  const auto events = window.controller()->recording(1).eventLog().events();
  QCOMPARE(window.list()->model()->rowCount(), static_cast<int>(events.size()));
  // And the keys go by it.
  window.controller()->showTime(1.6);
  window.press(Qt::Key_I);
  const auto next = std::ranges::find_if(
      events, [](const core::Event& event) { return event.time > 1.6 && isImpact(event); });
  QCOMPARE(window.time(), next->time);
}

void EventsWindowTest::copiesEventsAsCsv() {
  Window window;
  window.controller()->goTo(3);
  window.showEvents();
  window.clickRow(0);
  QTest::keyClick(window.list(), Qt::Key_Down, Qt::ShiftModifier);
  QTest::keyClick(window.list(), Qt::Key_C, Qt::ControlModifier);
  QStringList lines = QApplication::clipboard()->text().split("\r\n");
  QCOMPARE(lines.size(), 4);  // header, two events, end
  QVERIFY(lines[0].startsWith("time,event,weight"));
  // Not the ropes: C alone cuts them.
  window.clickRow(0);
  QTest::keyClick(window.list(), Qt::Key_C, Qt::ControlModifier);
  lines = QApplication::clipboard()->text().split("\r\n");
  QCOMPARE(lines.size(), window.list()->model()->rowCount() + 2);
}

QTEST_MAIN(EventsWindowTest)
#include "events_window_test.moc"
