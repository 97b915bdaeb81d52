// All windows can be used without seeing them, without a mouse, and with weak eyes.
#include <functional>
#include <memory>

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTextEdit>
#include <QTimer>
#include <QVBoxLayout>

#include "tests/support/access_check.h"
#include "tests/support/settle.h"
#include "ui/control/chart_size_dialog.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/selection.h"
#include "ui/files/scene_file.h"
#include "ui/help/tour.h"
#include "ui/main_window.h"
#include "ui/style/palette.h"
#include "ui/style/theme.h"
#include "ui/view/scene_area.h"
#include "ui/view/scene_view.h"

using tests::settle;
using ui::Command;
using ui::MainWindow;

namespace {

QByteArray listed(QStringList lines) {
  lines.removeDuplicates();
  return ('\n' + lines.join('\n')).toUtf8();
}

void addThemes() {
  QTest::addColumn<bool>("dark");
  QTest::newRow("light") << false;
  QTest::newRow("dark") << true;
}

void useColors(bool dark) {
  QApplication::setPalette(ui::paletteOf(dark ? ui::Theme::darkTheme() : ui::Theme::light()));
  settle();
}

}  // namespace

class AccessibilityWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void cleanup();
  void namesAndExplainsEverythingInTheWindow();
  void namesAndExplainsEverythingInOtherWindows();
  void namesAndExplainsEverythingInDialogs();
  void tellsScreenReadersWhatHappens();
  void comesEverywhereWithTab();
  void showsWhereTheKeyboardIs_data() { addThemes(); }
  void showsWhereTheKeyboardIs();
  void seesWhatIsPale();
  void canBeReadInAnyColors_data() { addThemes(); }
  void canBeReadInAnyColors();
  void leadsThroughTheTour_data() { addThemes(); }
  void leadsThroughTheTour();

 private:
  using Check = std::function<QStringList(QWidget&)>;
  QStringList inAllPanels(const Check& check) const;
  QStringList inOtherWindows(const Check& check) const;

  QTemporaryDir m_settings;
  std::unique_ptr<MainWindow> m_window;
};

void AccessibilityWindowTest::initTestCase() {
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
}

void AccessibilityWindowTest::init() {
  QSettings("angrycuts", "angrycuts").clear();
  m_window = std::make_unique<MainWindow>(ui::builtInScene("seven-weights"));
  m_window->setWindowState(Qt::WindowNoState);
  m_window->resize(1600, 900);
  m_window->show();
  QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
  m_window->controller()->stepOnce();
}

void AccessibilityWindowTest::cleanup() {
  m_window.reset();
  useColors(false);
}

QStringList AccessibilityWindowTest::inAllPanels(const Check& check) const {
  QStringList found;
  for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
    dock->show();
    dock->raise();
    settle();
    found << check(*m_window);
  }
  return found;
}

QStringList AccessibilityWindowTest::inOtherWindows(const Check& check) const {
  QStringList found;
  for (const Command command :
       {Command::kMeasure, Command::kWhenToCut, Command::kLessons, Command::kSheet}) {
    m_window->commands().action(command)->trigger();
    settle();
    QWidget* opened = QApplication::activeWindow();
    if (opened == m_window.get()) found << "no window opened";
    found << check(*opened);
    for (QTabBar* tabs : opened->findChildren<QTabBar*>()) {
      for (int i = 0; i < tabs->count(); ++i) {
        tabs->setCurrentIndex(i);
        settle();
        found << check(*opened);
      }
    }
    opened->close();
    m_window->activateWindow();
    settle();
  }
  return found;
}

void AccessibilityWindowTest::namesAndExplainsEverythingInTheWindow() {
  const QStringList nameless = inAllPanels(tests::namelessIn);
  QVERIFY2(nameless.isEmpty(), listed(nameless));
  const QStringList columns = inAllPanels(tests::unexplainedColumnsIn);
  QVERIFY2(columns.isEmpty(), listed(columns));
}

void AccessibilityWindowTest::namesAndExplainsEverythingInOtherWindows() {
  const QStringList nameless = inOtherWindows(tests::namelessIn);
  QVERIFY2(nameless.isEmpty(), listed(nameless));
  const QStringList columns = inOtherWindows(tests::unexplainedColumnsIn);
  QVERIFY2(columns.isEmpty(), listed(columns));
}

void AccessibilityWindowTest::namesAndExplainsEverythingInDialogs() {
  QStringList nameless;
  int seen = 0;
  const auto look = [&] {
    QTimer::singleShot(0, this, [&] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (!dialog) return;
      ++seen;
      nameless << tests::namelessIn(*dialog);
      dialog->reject();
    });
  };
  look();
  m_window->commands().action(Command::kKeys)->trigger();
  look();
  ui::askChartSize(m_window.get(), {160, 100});
  QCOMPARE(seen, 2);
  QVERIFY2(nameless.isEmpty(), listed(nameless));
}

void AccessibilityWindowTest::tellsScreenReadersWhatHappens() {
  // As a screen reader asks for it, and is told that it has changed.
  auto* view = m_window->findChild<ui::SceneArea*>()->views().front();
  const auto heard = [view] {
    return QAccessible::queryAccessibleInterface(view)->text(QAccessible::Value);
  };
  m_window->selection()->select(2);
  QTRY_VERIFY2(heard().startsWith("Weight 3 selected"), qPrintable(heard()));
  m_window->commands().action(Command::kCut)->trigger();
  m_window->controller()->stepOnce();
  QTRY_VERIFY2(heard().contains("cut", Qt::CaseInsensitive), qPrintable(heard()));
  m_window->commands().action(Command::kNextImpact)->trigger();
  QTRY_VERIFY2(heard().contains("mpact"), qPrintable(heard()));
}

void AccessibilityWindowTest::comesEverywhereWithTab() {
  const QStringList missed = inAllPanels(tests::missedByTab) + inOtherWindows(tests::missedByTab);
  QVERIFY2(missed.isEmpty(), listed(missed));
  const QStringList backward =
      inAllPanels(tests::backwardStepsOfTab) + inOtherWindows(tests::backwardStepsOfTab);
  QVERIFY2(backward.isEmpty(), listed(backward));
}

void AccessibilityWindowTest::showsWhereTheKeyboardIs() {
  QFETCH(bool, dark);
  useColors(dark);
  const QStringList unseen =
      inAllPanels(tests::focusNotSeenIn) + inOtherWindows(tests::focusNotSeenIn);
  QVERIFY2(unseen.isEmpty(), listed(unseen));
}

void AccessibilityWindowTest::seesWhatIsPale() {
  QWidget window;
  auto* layout = new QVBoxLayout(&window);
  auto* label = new QLabel("Kinetic energy");
  auto* page = new QTextEdit("A page");
  layout->addWidget(label);
  layout->addWidget(page);
  window.show();
  settle();
  QCOMPARE(tests::paleTextsIn(window), QStringList());
  QPalette pale = label->palette();
  pale.setColor(QPalette::WindowText, QColor(0xa0, 0xa0, 0xa0));
  label->setPalette(pale);
  page->setHtml("A <span style='color: #a0a0a0'>page</span>");
  QCOMPARE(tests::paleTextsIn(window).size(), 2);
}

void AccessibilityWindowTest::canBeReadInAnyColors() {
  QFETCH(bool, dark);
  useColors(dark);
  const QStringList pale = inAllPanels(tests::paleTextsIn) + inOtherWindows(tests::paleTextsIn);
  QVERIFY2(pale.isEmpty(), listed(pale));
}

void AccessibilityWindowTest::leadsThroughTheTour() {
  QFETCH(bool, dark);
  useColors(dark);
  m_window->commands().action(Command::kTour)->trigger();
  settle();
  const QPointer<ui::Tour> tour = m_window->findChild<ui::Tour*>();
  QStringList faults;
  for (int hint = 0; hint < 5; ++hint) {
    QCOMPARE(tour->hint(), hint);
    const QAccessibleInterface* bubble = QAccessible::queryAccessibleInterface(tour->bubble());
    QVERIFY(!bubble->text(QAccessible::Name).isEmpty());
    QVERIFY(bubble->text(QAccessible::Description).size() > 20);
    QCOMPARE(tests::controlsIn(*tour).size(), hint < 4 ? 3 : 2);
    for (const auto& check :
         {Check(tests::namelessIn), Check(tests::missedByTab), Check(tests::backwardStepsOfTab),
          Check(tests::focusNotSeenIn), Check(tests::paleTextsIn)})
      faults << check(*tour);
    tour->findChildren<QPushButton*>().last()->setFocus();
    QTest::keyClick(tour, Qt::Key_Return);
    settle();
  }
  QVERIFY2(faults.isEmpty(), listed(faults));
  QTRY_VERIFY(!tour);
}

QTEST_MAIN(AccessibilityWindowTest)
#include "accessibility_window_test.moc"
