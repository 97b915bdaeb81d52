// Every text fits its widget, in all languages, on a screen of 1280 × 720 pixels.
#include "tests/support/text_fit.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QTabBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTimer>

#include "tests/support/offscreen_screen.h"
#include "tests/support/settle.h"
#include "ui/control/chart_size_dialog.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/control/translations.h"
#include "ui/files/lessons.h"
#include "ui/files/scene_file.h"
#include "ui/help/help_window.h"
#include "ui/help/tour.h"
#include "ui/main_window.h"
#include "ui/panels/cut_window.h"
#include "ui/panels/help_dialogs.h"
#include "ui/panels/lesson_chooser.h"
#include "ui/panels/trade_window.h"

using tests::settle;
using ui::Command;
using ui::Language;
using ui::MainWindow;

namespace {

constexpr QSize kScreen(1280, 720);
constexpr int kTitleBar = 24;  // px, of the desktop's frame

void addLanguages() {
  QTest::addColumn<Language>("language");
  for (int i = 1; i < ui::kLanguageCount; ++i) {
    const auto language = static_cast<Language>(i);
    QTest::newRow(qPrintable(ui::nameOf(language))) << language;
  }
}

}  // namespace

class TextFitTest : public QObject {
  Q_OBJECT

 public:
  static void initMain();

 private slots:
  void initTestCase() { QCOMPARE(QGuiApplication::primaryScreen()->size(), kScreen); }
  void init();
  void cleanup();
  void seesWhatIsCutOff();
  void seesWhatIsCutOffInListsAndPages();
  void fitsInThePanels_data() { addLanguages(); }
  void fitsInThePanels();
  void namesRunsWholeInTheComparison_data() { addLanguages(); }
  void namesRunsWholeInTheComparison();
  void fitsInTheOtherWindows_data() { addLanguages(); }
  void fitsInTheOtherWindows();
  void fitsInTheDialogs_data() { addLanguages(); }
  void fitsInTheDialogs();
  void fitsInTheHelp_data() { addLanguages(); }
  void fitsInTheHelp();
  void fitsInTheTour_data() { addLanguages(); }
  void fitsInTheTour();

 private:
  std::unique_ptr<MainWindow> m_window;
};

void TextFitTest::initMain() {
  static const QTemporaryDir folder;
  tests::useScreen(kScreen);
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
}

void TextFitTest::init() {
  m_window = std::make_unique<MainWindow>(ui::builtInScene("seven-weights"));
  m_window->setWindowState(Qt::WindowNoState);
  m_window->resize(kScreen - QSize(0, kTitleBar));
  m_window->show();
}

void TextFitTest::cleanup() {
  m_window.reset();
  ui::speak(Language::kEnglish);
}

void TextFitTest::seesWhatIsCutOff() {
  QWidget window;
  auto* label = new QLabel("Kinetic energy", &window);
  auto* button = new QPushButton("Give up the change", &window);
  label->resize(label->sizeHint());
  button->resize(button->sizeHint());
  window.show();
  QCOMPARE(tests::cutTextsIn(window), QStringList());
  label->resize(label->width() - 5, label->height());
  button->resize(button->width() - 5, button->height());
  QCOMPARE(tests::cutTextsIn(window).size(), 2);
}

void TextFitTest::seesWhatIsCutOffInListsAndPages() {
  QWidget window;
  auto* list = new QListWidget(&window);
  list->addItem("Two kinds of Euler");
  auto* page = new QTextBrowser(&window);
  page->setHtml("<p>Title</p><pre>a line that does not wrap, as it is the text of a program</pre>");
  list->resize(400, 100);
  page->resize(800, 100);
  window.show();
  settle();
  QCOMPARE(tests::cutTextsIn(window), QStringList());
  list->resize(80, 100);
  page->resize(200, 100);
  settle();
  QCOMPARE(tests::cutTextsIn(window).size(), 2);
}

void TextFitTest::fitsInThePanels() {
  QFETCH(Language, language);
  m_window->speak(language);
  m_window->controller()->stepOnce();
  QStringList cut;
  for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
    dock->show();
    dock->raise();
    settle();
    cut << tests::cutTextsIn(*m_window);
  }
  cut.removeDuplicates();
  QVERIFY2(cut.isEmpty(), qPrintable('\n' + cut.join('\n')));
  const QSize least = m_window->minimumSizeHint();
  QVERIFY2(least.width() <= kScreen.width(), qPrintable(QString::number(least.width())));
  QVERIFY2(least.height() <= kScreen.height() - kTitleBar,
           qPrintable(QString::number(least.height())));
}

void TextFitTest::namesRunsWholeInTheComparison() {
  QFETCH(Language, language);
  m_window->speak(language);
  auto* dock = m_window->findChild<QDockWidget*>("comparison");
  dock->raise();
  settle();
  const auto* table = dock->findChild<QTableWidget*>();
  QVERIFY(table->isVisible() && table->rowCount() == 2);
  const int needed = static_cast<const QAbstractItemView*>(table)->sizeHintForColumn(0);
  QVERIFY2(table->columnWidth(0) >= needed, qPrintable(QStringLiteral("%1: %2 of %3, %4")
                                                           .arg(table->item(1, 0)->text())
                                                           .arg(table->columnWidth(0))
                                                           .arg(needed)
                                                           .arg(dock->width())));
}

void TextFitTest::fitsInTheOtherWindows() {
  QFETCH(Language, language);
  m_window->speak(language);
  QStringList cut;
  for (const Command command : {Command::kMeasure, Command::kWhenToCut, Command::kLessons})
    m_window->commands().action(command)->trigger();
  settle();
  for (QDialog* dialog : m_window->findChildren<QDialog*>()) {
    cut << tests::cutTextsIn(*dialog);
    for (QTabWidget* tabs : dialog->findChildren<QTabWidget*>()) {
      for (int i = 0; i < tabs->count(); ++i) {
        tabs->setCurrentIndex(i);
        settle();
        cut << tests::cutTextsIn(*dialog);
      }
    }
    QVERIFY(dialog->width() <= kScreen.width());
    QVERIFY(dialog->height() <= kScreen.height());
  }
  cut.removeDuplicates();
  QVERIFY2(cut.isEmpty(), qPrintable('\n' + cut.join('\n')));
}

void TextFitTest::fitsInTheDialogs() {
  QFETCH(Language, language);
  m_window->speak(language);
  QStringList cut;
  int seen = 0;
  const auto look = [&] {
    QTimer::singleShot(0, this, [&] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (!dialog) return;
      ++seen;
      settle();
      cut << tests::cutTextsIn(*dialog);
      if (dialog->width() > kScreen.width() || dialog->height() > kScreen.height())
        cut << dialog->windowTitle() + " is larger than the screen";
      dialog->reject();
    });
  };
  look();
  m_window->commands().action(Command::kKeys)->trigger();
  look();
  m_window->commands().action(Command::kAbout)->trigger();
  look();
  ui::askChartSize(m_window.get(), {160, 100});
  QCOMPARE(seen, 3);
  QVERIFY2(cut.isEmpty(), qPrintable('\n' + cut.join('\n')));
}

void TextFitTest::fitsInTheHelp() {
  QFETCH(Language, language);
  m_window->speak(language);
  QStringList cut, seen;
  for (const Command chapter : {Command::kGuide, Command::kModel, Command::kSheet}) {
    m_window->commands().action(chapter)->trigger();
    settle();
    const auto* help = m_window->findChild<ui::HelpWindow*>();
    QVERIFY(help->width() <= kScreen.width() && help->height() <= kScreen.height() - kTitleBar);
    QVERIFY(help->contents()->count() > 3);
    for (int row = 0; row < help->contents()->count(); ++row) {
      help->contents()->setCurrentRow(row);
      settle();
      seen << help->page()->document()->firstBlock().text();
      cut << tests::cutTextsIn(*help);
    }
  }
  seen.removeDuplicates();
  QCOMPARE(static_cast<std::size_t>(seen.size()), 2 + ui::lessons().size());
  cut.removeDuplicates();
  QVERIFY2(cut.isEmpty(), qPrintable('\n' + cut.join('\n')));
}

void TextFitTest::fitsInTheTour() {
  QFETCH(Language, language);
  m_window->speak(language);
  m_window->commands().action(Command::kTour)->trigger();
  settle();
  auto* tour = m_window->findChild<ui::Tour*>();
  QStringList cut;
  for (int hint = 0; hint < tour->hintCount(); ++hint) {
    QCOMPARE(tour->hint(), hint);
    cut << tests::cutTextsIn(*tour);
    const QRect bubble = tour->bubble()->geometry();
    if (!tour->rect().contains(bubble)) cut << QStringLiteral("hint %1: off the window").arg(hint);
    if (bubble.intersects(tour->pointedAt()))
      cut << QStringLiteral("hint %1: over what it points at").arg(hint);
    QTest::keyClick(tour, Qt::Key_Return);
    settle();
  }
  QVERIFY2(cut.isEmpty(), qPrintable('\n' + cut.join('\n')));
}

QTEST_MAIN(TextFitTest)
#include "text_fit_test.moc"
