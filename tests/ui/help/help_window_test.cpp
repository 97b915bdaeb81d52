#include "ui/help/help_window.h"

#include <algorithm>

#include <QAbstractTextDocumentLayout>
#include <QAction>
#include <QBuffer>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QPainter>
#include <QPdfWriter>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <QScreen>
#include <QScrollBar>
#include <QSettings>
#include <QStatusBar>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextLayout>
#include <QTimer>
#include <QToolButton>

#include "core/scene/arrangement.h"
#include "ui/control/commands.h"
#include "ui/control/scene_editor.h"
#include "ui/control/settings.h"
#include "ui/files/lessons.h"
#include "ui/files/long_text.h"
#include "ui/files/scene_file.h"
#include "ui/help/help_document.h"
#include "ui/help/paper.h"
#include "ui/main_window.h"
#include "ui/panels/lesson_panel.h"
#include "ui/style/palette.h"
#include "ui/style/theme.h"

using ui::Command;
using ui::HelpWindow;

namespace {

/// The window on the screen, with a lesson in it.
class ShownWindow : public ui::MainWindow {
 public:
  explicit ShownWindow(const char* lesson = "pile") : MainWindow(ui::builtInScene(lesson)) {
    setWindowState(Qt::WindowNoState);
    resize(1280, 720);
    show();
    if (!QTest::qWaitForWindowActive(this)) qFatal("the window is not active");
  }

  HelpWindow* press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(this, key, modifiers);
    auto* help = findChild<HelpWindow*>();
    if (!help || !QTest::qWaitForWindowActive(help)) qFatal("no help");
    return help;
  }
};

QString textOf(const HelpWindow* help) {
  return help->page()->toPlainText();
}

/// Of its first block.
QString titleOf(const HelpWindow* help) {
  return help->page()->document()->firstBlock().text();
}

QStringList itemsOf(const QListWidget* list) {
  QStringList items;
  for (int row = 0; row < list->count(); ++row) items << list->item(row)->text();
  return items;
}

/// How wide its widest line would like to be.
double widestLineOf(const QTextDocument& document) {
  double widest = 0;
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
    for (int i = 0; i < block.layout()->lineCount(); ++i)
      widest = std::max(widest, block.layout()->lineAt(i).naturalTextWidth());
  return widest;
}

int pagesOf(const QTextDocument& document, const QString& file) {
  const QString error = ui::writePdf(document, QStringLiteral("Test"), file);
  if (!error.isEmpty()) qFatal("%s", qPrintable(error));
  QFile pdf(file);
  if (!pdf.open(QIODevice::ReadOnly)) qFatal("no file");
  const QByteArray bytes = pdf.readAll();
  const QByteArray mark = "/Count ";
  return bytes.mid(bytes.indexOf(mark) + mark.size(), 2).trimmed().toInt();
}

QPushButton* buttonOf(const HelpWindow* help, const char* words) {
  for (QPushButton* button : help->findChildren<QPushButton*>())
    if (button->text().remove('&') == QString::fromUtf8(words)) return button;
  qFatal("no button %s", words);
}

}  // namespace

class HelpWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void cleanup() { ui::speak(ui::Language::kEnglish); }
  void opensTheSheetOfTheLesson();
  void aButtonBesideTheLessonOpensItsSheet();
  void anOwnSceneOpensTheSheetsToo();
  void leadsToEverySheet();
  void opensTheGuideAndTheModelByKeys();
  void drawsKeysIconsAndEquations();
  void goesToAHeading();
  void goesOnInAnotherLanguage();
  void needsNoMoreThanTheWidthOfASmallScreen();
  void needsNoMoreThanTheWidthOfPaper();
  void staysBesideTheWindow();
  void isReadInLightAndDark();
  void everySheetIsOnePageInEveryLanguage();
  void savesTheSheetAsPdf();
  void printsTheSheetIntoAFile();

 private:
  QTemporaryDir m_folder;
};

void HelpWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void HelpWindowTest::init() {
  QSettings("angrycuts", "angrycuts").clear();
}

void HelpWindowTest::opensTheSheetOfTheLesson() {
  ShownWindow window("newtons-cradle");
  const HelpWindow* help = window.press(Qt::Key_L, Qt::ShiftModifier);
  QCOMPARE(titleOf(help), ui::lessonNamed("newtons-cradle").title);
  QCOMPARE(help->contents()->currentItem()->text(), titleOf(help));
  QVERIFY(textOf(help).contains("2.35 m/s"));
}

void HelpWindowTest::aButtonBesideTheLessonOpensItsSheet() {
  ShownWindow window("pile");
  for (QToolButton* button : window.findChild<ui::LessonPanel*>()->findChildren<QToolButton*>())
    if (button->text() == "Sheet") QTest::mouseClick(button, Qt::LeftButton);
  const auto* help = window.findChild<HelpWindow*>();
  QVERIFY(help && help->isVisible());
  QCOMPARE(titleOf(help), ui::lessonNamed("pile").title);
}

void HelpWindowTest::anOwnSceneOpensTheSheetsToo() {
  ShownWindow window;
  window.editor()->replace(core::withWeightCount(core::Scene(), 1));
  const HelpWindow* help = window.press(Qt::Key_L, Qt::ShiftModifier);
  QCOMPARE(help->contents()->count(), static_cast<int>(ui::lessons().size()));
  QVERIFY(!titleOf(help).isEmpty());
}

void HelpWindowTest::leadsToEverySheet() {
  ShownWindow window("one-pendulum");
  const HelpWindow* help = window.press(Qt::Key_L, Qt::ShiftModifier);
  for (const ui::Lesson& lesson : ui::lessons()) {
    QCOMPARE(titleOf(help), lesson.title);
    QTest::keyClick(help->contents(), Qt::Key_Down);
  }
}

void HelpWindowTest::opensTheGuideAndTheModelByKeys() {
  ShownWindow window;
  const HelpWindow* help = window.press(Qt::Key_F1, Qt::ShiftModifier);
  QCOMPARE(titleOf(help), QString("Quick guide"));
  QVERIFY(itemsOf(help->contents()).contains("Charts and figures"));
  QApplication::setActiveWindow(&window);
  QCOMPARE(window.press(Qt::Key_M), help);
  QCOMPARE(titleOf(help), QString("The model"));
  QVERIFY(itemsOf(help->contents()).contains("Swing"));
  for (const Command command : {Command::kGuide, Command::kModel, Command::kSheet, Command::kTour})
    QVERIFY(window.menuBar()->actions().last()->menu()->actions().contains(
        window.commands().action(command)));
}

void HelpWindowTest::drawsKeysIconsAndEquations() {
  ShownWindow window;
  const HelpWindow* help = window.press(Qt::Key_F1, Qt::ShiftModifier);
  const QChar drawing = QChar::ObjectReplacementCharacter;
  for (const Qt::Key chapter : {Qt::Key_F1, Qt::Key_M}) {
    QApplication::setActiveWindow(&window);
    window.press(chapter, chapter == Qt::Key_F1 ? Qt::ShiftModifier : Qt::NoModifier);
    QVERIFY(textOf(help).count(drawing) > 40);
    for (const char16_t sign : {u'`', u'\xE000', u'\xE001'})
      QVERIFY(!textOf(help).contains(QChar(sign)));
    QVERIFY(!textOf(help).contains(".svg"));
  }
}

void HelpWindowTest::goesToAHeading() {
  ShownWindow window;
  const HelpWindow* help = window.press(Qt::Key_M);
  QListWidget* contents = help->contents();
  contents->setCurrentItem(contents->findItems("Rest", Qt::MatchExactly).first());
  const QTextCursor top = help->page()->cursorForPosition(QPoint(40, 12));
  QVERIFY2(top.block().text() == "Rest" || top.block().next().text() == "Rest",
           qPrintable(top.block().text()));
}

void HelpWindowTest::goesOnInAnotherLanguage() {
  ShownWindow window;
  const HelpWindow* help = window.press(Qt::Key_M);
  help->contents()->setCurrentRow(3);
  const QString english = textOf(help);
  QStringList titles{titleOf(help)};
  for (const ui::Language language : {ui::Language::kSwedish, ui::Language::kGerman,
                                      ui::Language::kFrench, ui::Language::kSpanish}) {
    window.speak(language);
    help = window.findChild<HelpWindow*>();
    QVERIFY(help && help->isVisible());
    QCOMPARE(help->contents()->currentRow(), 3);
    QVERIFY(help->page()->verticalScrollBar()->value() > 0);
    QVERIFY(textOf(help) != english);
    titles << titleOf(help);
  }
  window.speak(ui::Language::kEnglish);
  QCOMPARE(titles.join(' '), QString("The model Modellen Das Modell Le modèle El modelo"));
  help = window.findChild<HelpWindow*>();
  QCOMPARE(textOf(help), english);
  // What is closed stays closed.
  QTest::keyClick(window.findChild<HelpWindow*>(), Qt::Key_Escape);
  window.speak(ui::Language::kGerman);
  help = window.findChild<HelpWindow*>();
  QVERIFY(!help || !help->isVisible());
}

void HelpWindowTest::needsNoMoreThanTheWidthOfASmallScreen() {
  constexpr double kRoom = 870;  // px: what a screen of 1280 × 720 has beside the contents
  QFont font;
  font.setPointSizeF(12);  // the window's
  const auto look = ui::PageLook::of(QApplication::palette(), font);
  for (const QString& language : ui::languagesOf("help")) {
    const auto page =
        ui::helpDocument(ui::longText("help", "model", language), ui::CodeMeans::kMath, look);
    page->setTextWidth(kRoom);
    QVERIFY(page->size().height() > 3000);  // all of it is laid out
    QVERIFY2(widestLineOf(*page) <= kRoom - 2 * page->documentMargin(), qPrintable(language));
  }
}

void HelpWindowTest::needsNoMoreThanTheWidthOfPaper() {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter paper(&buffer);
  paper.setPageSize(QPageSize(QPageSize::A4));
  paper.setPageMargins(QMarginsF());
  constexpr double kMargin = 2 / 2.54;  // inches: what QTextDocument::print() leaves
  for (const QString& language : ui::languagesOf("help")) {
    const auto pages = ui::helpDocument(ui::longText("help", "model", language),
                                        ui::CodeMeans::kMath, ui::PageLook::onPaper());
    pages->documentLayout()->setPaintDevice(&paper);
    QTextFrameFormat margins = pages->rootFrame()->frameFormat();
    margins.setMargin(kMargin * QGuiApplication::primaryScreen()->logicalDotsPerInch());
    pages->rootFrame()->setFrameFormat(margins);
    pages->setPageSize(QSizeF(paper.width(), paper.height()));
    QVERIFY(pages->pageCount() > 3);
    const double room = paper.width() - 2 * kMargin * paper.logicalDpiX();
    QVERIFY2(widestLineOf(*pages) <= room + 1, qPrintable(language));
  }
}

void HelpWindowTest::staysBesideTheWindow() {
  ShownWindow window;
  HelpWindow* help = window.press(Qt::Key_M);
  QVERIFY(!help->isModal());
  QTest::keyClick(help, Qt::Key_Escape);
  QVERIFY(!help->isVisible());
}

void HelpWindowTest::isReadInLightAndDark() {
  ShownWindow window;
  const HelpWindow* help = window.press(Qt::Key_M);
  for (const ui::Theme& theme : {ui::Theme::darkTheme(), ui::Theme::light()}) {
    QApplication::setPalette(ui::paletteOf(theme));
    QCoreApplication::processEvents();
    const QImage page = help->page()->viewport()->grab().toImage();
    int ink = 0, paper = 0;
    for (int y = 0; y < page.height(); ++y) {
      for (int x = 0; x < page.width(); ++x) {
        const int gray = qGray(page.pixel(x, y));
        (theme.dark == (gray > 128) ? ink : paper) += 1;
      }
    }
    QVERIFY(ink > 1000 && paper > 10 * ink);
    // On paper it is black on white in either case.
    const auto pages = help->pagesForPaper();
    pages->setTextWidth(600);
    QImage sheet(640, 800, QImage::Format_RGB32);
    sheet.fill(Qt::white);
    QPainter painter(&sheet);
    pages->drawContents(&painter);
    painter.end();
    int dark = 0;
    for (int y = 0; y < sheet.height(); ++y)
      for (int x = 0; x < sheet.width(); ++x) dark += qGray(sheet.pixel(x, y)) < 100;
    QVERIFY(dark > 2000);
  }
}

void HelpWindowTest::everySheetIsOnePageInEveryLanguage() {
  for (const QString& language : ui::languagesOf("lessons")) {
    for (const ui::Lesson& lesson : ui::lessons()) {
      const auto sheet = ui::helpDocument(ui::longText("lessons", lesson.name, language),
                                          ui::CodeMeans::kKeys, ui::PageLook::onPaper());
      QVERIFY(sheet->defaultFont().pointSizeF() >= 12);
      const int pages = pagesOf(*sheet, m_folder.filePath("sheet.pdf"));
      QVERIFY2(pages == 1, qPrintable(language + '/' + lesson.name));
    }
  }
}

void HelpWindowTest::savesTheSheetAsPdf() {
  ShownWindow window("pile");
  HelpWindow* help = window.press(Qt::Key_L, Qt::ShiftModifier);
  const QString file = m_folder.filePath("my sheet.pdf");
  QTimer::singleShot(0, this, [&file] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (!dialog) return;
    dialog->selectFile(file);
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(file);
    QMetaObject::invokeMethod(dialog, "accept");
  });
  buttonOf(help, "Save as PDF…")->click();
  QFile pdf(file);
  QVERIFY(pdf.open(QIODevice::ReadOnly));
  QVERIFY(pdf.readAll().startsWith("%PDF"));
  // The window says so, as it says everything that was done.
  QCOMPARE(window.statusBar()->currentMessage(), "Saved " + file);
}

void HelpWindowTest::printsTheSheetIntoAFile() {
  ShownWindow window("pile");
  HelpWindow* help = window.press(Qt::Key_L, Qt::ShiftModifier);
  const QString file = m_folder.filePath("printed.pdf");
  QTimer::singleShot(0, this, [&file] {
    auto* dialog = qobject_cast<QPrintDialog*>(QApplication::activeModalWidget());
    if (!dialog) return;
    dialog->printer()->setOutputFileName(file);
    dialog->done(QDialog::Accepted);
  });
  buttonOf(help, "Print…")->click();
  QVERIFY(QFile(file).size() > 5000);
}

QTEST_MAIN(HelpWindowTest)
#include "help_window_test.moc"
