#include "ui/help/help_window.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <QAbstractTextDocumentLayout>
#include <QDialogButtonBox>
#include <QDir>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QScrollBar>
#include <QTabBar>
#include <QTextBlock>
#include <QTextDocument>
#include <QVBoxLayout>

#include "ui/control/file_dialog.h"
#include "ui/files/lessons.h"
#include "ui/files/long_text.h"
#include "ui/help/help_document.h"
#include "ui/help/help_page.h"
#include "ui/help/paper.h"
#include "ui/style/icons.h"

namespace ui {
namespace {

constexpr QSize kFirstSize(1120, 840);
constexpr double kScreenShare = 0.94;
constexpr int kPageMargin = 20;          // px
constexpr int kItemPadding = 40;         // px: the list's frame and scroll bar
constexpr double kContentsShare = 0.34;  // of the window, at most

bool isHeading(const QTextBlock& block) {
  return block.blockFormat().headingLevel() == 2;
}

}  // namespace

HelpWindow::HelpWindow(QWidget* parent)
    : QDialog(parent),
      m_chapters(new QTabBar),
      m_contents(new QListWidget),
      m_page(new HelpPage),
      m_lesson(lessons().front().name) {
  setObjectName("help");
  setWindowTitle(tr("Help"));
  setWindowFlag(Qt::WindowMaximizeButtonHint);
  for (const QString& name : {tr("Quick guide"), tr("The model"), tr("Teacher's sheets")})
    m_chapters->addTab(name);
  m_chapters->setDrawBase(false);
  m_chapters->setExpanding(false);
  m_chapters->setAccessibleName(tr("Chapters"));
  m_chapters->setAccessibleDescription(tr("Guide, model or teacher's sheets"));
  m_contents->setAccessibleName(tr("Contents"));
  m_contents->setAccessibleDescription(tr("What this chapter has; the one chosen is shown"));
  m_contents->setToolTip(m_contents->accessibleDescription());
  m_contents->setFrameShape(QFrame::NoFrame);
  m_contents->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_contents->setSpacing(2);
  m_contents->setTextElideMode(Qt::ElideRight);
  m_page->setAccessibleName(tr("Text"));
  m_page->setAccessibleDescription(tr("The page that is open"));
  auto* book = new QHBoxLayout;
  book->addWidget(m_contents);
  book->addWidget(m_page, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_chapters);
  layout->addLayout(book, 1);
  layout->addWidget(buttons());
  resize(kFirstSize.boundedTo(screen()->availableSize() * kScreenShare));
  connect(m_chapters, &QTabBar::currentChanged, this, &HelpWindow::showChapter);
  connect(m_contents, &QListWidget::currentRowChanged, this, &HelpWindow::goTo);
  showChapter();
}

QWidget* HelpWindow::buttons() {
  auto* box = new QDialogButtonBox;
  const auto add = [&](const char* name, const QString& words, const QString& tip, auto slot) {
    QPushButton* button = box->addButton(words, QDialogButtonBox::ActionRole);
    button->setIcon(icon(name));
    button->setToolTip(tip);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, slot);
    return button;
  };
  add("print", tr("&Print…"), tr("Print these pages, black on white"), &HelpWindow::print)
      ->setShortcut(QKeySequence::Print);
  add("save", tr("&Save as PDF…"), tr("Save these pages as a file"), &HelpWindow::savePdf)
      ->setShortcut(QKeySequence::Save);
  // Last, as it stands: Tab goes in the order in which buttons are made.
  QPushButton* close = box->addButton(QDialogButtonBox::Close);
  close->setIcon(icon("close"));
  close->setToolTip(tr("Close this window"));
  connect(box, &QDialogButtonBox::rejected, this, &QDialog::reject);
  return box;
}

void HelpWindow::bringUp(Chapter chapter) {
  m_chapters->setCurrentIndex(static_cast<int>(chapter));
  show();
  raise();
  activateWindow();
  m_page->setFocus();
}

void HelpWindow::bringUpSheet(const QString& lesson) {
  m_lesson = lesson;
  if (chapter() == Chapter::kSheets) showChapter();
  bringUp(Chapter::kSheets);
}

HelpWindow::Place HelpWindow::place() const {
  return {saveGeometry(), chapter(), m_contents->currentRow()};
}

void HelpWindow::bringUp(const Place& place) {
  bringUp(place.chapter);
  restoreGeometry(place.geometry);
  m_contents->setCurrentRow(place.row);
}

HelpWindow::Chapter HelpWindow::chapter() const {
  return static_cast<Chapter>(m_chapters->currentIndex());
}

void HelpWindow::showChapter() {
  std::unique_ptr<QTextDocument> text = textOnScreen();
  listContents(*text);
  showText(std::move(text));
}

/// Of the sheets: the lessons; else the headings of the text.
void HelpWindow::listContents(const QTextDocument& text) {
  const QSignalBlocker quiet(m_contents);
  m_contents->clear();
  if (chapter() == Chapter::kSheets) {
    for (const Lesson& lesson : lessons()) {
      auto* item = new QListWidgetItem(lesson.title, m_contents);
      item->setData(Qt::UserRole, lesson.name);
      if (lesson.name == m_lesson) m_contents->setCurrentItem(item);
    }
  } else {
    for (QTextBlock block = text.begin(); block.isValid(); block = block.next()) {
      if (!isHeading(block)) continue;
      auto* item = new QListWidgetItem(block.text(), m_contents);
      item->setData(Qt::UserRole, block.position());
    }
    m_contents->setCurrentRow(0);
  }
  const int wanted = m_contents->sizeHintForColumn(0) + kItemPadding;
  m_contents->setFixedWidth(std::min(wanted, static_cast<int>(width() * kContentsShare)));
}

std::unique_ptr<QTextDocument> HelpWindow::textOnScreen() const {
  return text(PageLook::of(m_page->palette(), font()));
}

/// What is open, in that look.
std::unique_ptr<QTextDocument> HelpWindow::text(const PageLook& look) const {
  switch (chapter()) {
    case Chapter::kGuide:
      return helpDocument(longText("help", "guide"), CodeMeans::kKeys, look);
    case Chapter::kModel:
      return helpDocument(longText("help", "model"), CodeMeans::kMath, look);
    case Chapter::kSheets:
      break;
  }
  return helpDocument(longText("lessons", m_lesson), CodeMeans::kKeys, look);
}

void HelpWindow::showText(std::unique_ptr<QTextDocument> text) {
  text->setDocumentMargin(kPageMargin);
  text->setParent(m_page);
  // Laid out as wide as the page will be: else a scroll bar for what was wider may stay.
  layout()->activate();
  text->setTextWidth(m_page->viewport()->width());
  text->documentLayout()->documentSize();
  // The browser deletes its own first one itself.
  const QTextDocument* before = m_page->document();
  const bool isOurs = before->parent() == m_page;
  m_page->setDocument(text.release());
  if (isOurs) delete before;
  m_page->moveCursor(QTextCursor::Start);
}

void HelpWindow::goTo(int row) {
  const QListWidgetItem* item = m_contents->item(row);
  if (!item) return;
  if (chapter() == Chapter::kSheets) {
    m_lesson = item->data(Qt::UserRole).toString();
    return showText(textOnScreen());
  }
  const QTextBlock block = m_page->document()->findBlock(item->data(Qt::UserRole).toInt());
  const QRectF place = m_page->document()->documentLayout()->blockBoundingRect(block);
  m_page->verticalScrollBar()->setValue(static_cast<int>(place.top()));
}

std::unique_ptr<QTextDocument> HelpWindow::pagesForPaper() const {
  return text(PageLook::onPaper());
}

QString HelpWindow::title() const {
  return chapter() == Chapter::kSheets ? lessonNamed(m_lesson).title
                                       : m_chapters->tabText(m_chapters->currentIndex());
}

void HelpWindow::print() {
  if (askAndPrint(*pagesForPaper(), title(), this)) emit said(tr("Printed %1").arg(title()));
}

void HelpWindow::savePdf() {
  const QString file = askWhereToSave(this, tr("Save as PDF"), fileNameFrom(title()) + ".pdf",
                                      {tr("PDF document (*.pdf)")});
  if (file.isEmpty()) return;
  const QString error = writePdf(*pagesForPaper(), title(), file);
  if (error.isEmpty()) {
    emit said(tr("Saved %1").arg(QDir::toNativeSeparators(file)));
  } else {
    QMessageBox::warning(this, tr("Not saved"), error);
  }
}

void HelpWindow::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  const bool looksChanged =
      event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange;
  if (!looksChanged) return;
  const int scrolled = m_page->verticalScrollBar()->value();
  const int row = m_contents->currentRow();
  showChapter();
  const QSignalBlocker quiet(m_contents);
  m_contents->setCurrentRow(row);
  m_page->verticalScrollBar()->setValue(scrolled);
}

}  // namespace ui
