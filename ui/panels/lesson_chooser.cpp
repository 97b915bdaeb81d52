#include "ui/panels/lesson_chooser.h"

#include <algorithm>
#include <memory>

#include <QDialogButtonBox>
#include <QEvent>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QScrollBar>
#include <QVBoxLayout>

#include "ui/control/background_task.h"
#include "ui/files/lessons.h"
#include "ui/files/scene_file.h"
#include "ui/panels/lesson_card.h"
#include "ui/style/icons.h"
#include "ui/style/theme.h"
#include "ui/view/scene_preview.h"

namespace ui {
namespace {

constexpr QSize kFirstSize(1360, 860);
constexpr double kScreenShare = 0.94;

/// Cards in rows: left and right go through all of them, up and down keep the column.
class CardList : public QListWidget {
 protected:
  QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override {
    const int width = gridSize().width();
    const int columns = width > 0 ? std::max(1, viewport()->width() / width) : 1;
    switch (action) {
      case MoveRight:
      case MoveNext:
        return moved(1);
      case MoveLeft:
      case MovePrevious:
        return moved(-1);
      case MoveDown:
        return moved(columns);
      case MoveUp:
        return moved(-columns);
      default:
        return QListWidget::moveCursor(action, modifiers);
    }
  }

 private:
  /// Below a row that is not full the last card is the nearest.
  QModelIndex moved(int by) const {
    const int last = count() - 1, row = currentRow() + by;
    if (row < 0) return currentIndex();
    return model()->index(std::min(row, last), 0);
  }
};

}  // namespace

LessonChooser::LessonChooser(QWidget* parent)
    : QDialog(parent), m_list(new CardList), m_painter(new BackgroundTask(this)) {
  setObjectName("lessons");
  setWindowTitle(tr("Lessons"));
  m_list->setViewMode(QListView::IconMode);
  m_list->setMovement(QListView::Static);
  m_list->setResizeMode(QListView::Adjust);
  m_list->setUniformItemSizes(true);
  m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_list->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  m_list->setFrameShape(QFrame::NoFrame);
  m_list->setMouseTracking(true);
  m_list->setItemDelegate(new LessonCard(m_list));
  m_list->setAccessibleName(tr("Lessons"));
  m_list->setAccessibleDescription(tr("Arrow keys and Enter, or a click, open a lesson."));
  m_list->setToolTip(m_list->accessibleDescription());
  addLessons();

  auto* hint = new QLabel(tr("Arrow keys and Enter, or a click, open a lesson."));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Close);
  buttons->button(QDialogButtonBox::Open)->setDefault(true);
  buttons->button(QDialogButtonBox::Open)->setIcon(icon("open"));
  buttons->button(QDialogButtonBox::Close)->setIcon(icon("close"));
  auto* below = new QHBoxLayout;
  below->setContentsMargins(12, 0, 12, 8);
  below->addWidget(hint, 1);
  below->addWidget(buttons);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 0, 0);
  layout->addWidget(m_list, 1);
  layout->addLayout(below);
  resize(kFirstSize.boundedTo(screen()->availableSize() * kScreenShare));

  connect(m_list, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { choose(m_list->row(item)); });
  connect(buttons, &QDialogButtonBox::accepted, this, [this] { choose(m_list->currentRow()); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void LessonChooser::addLessons() {
  for (const Lesson& lesson : lessons()) {
    auto* item = new QListWidgetItem(lesson.title, m_list);
    item->setData(LessonCard::kSentence, lesson.look);
    item->setData(LessonCard::kName, lesson.name);
    item->setData(Qt::AccessibleDescriptionRole, lesson.look);
    m_sentences.append(lesson.look);
  }
  m_list->setCurrentRow(0);
}

void LessonChooser::bringUp(const QString& current) {
  for (int row = 0; row < m_list->count(); ++row)
    if (m_list->item(row)->data(LessonCard::kName).toString() == current)
      m_list->setCurrentRow(row);
  open();
  m_list->setFocus();
  m_list->scrollToItem(m_list->currentItem());
}

/// As many columns as are wide enough, all equally wide.
void LessonChooser::layOut() {
  const int width = m_list->viewport()->width() - 1;
  const int columns = std::max(1, width / LessonCard::leastWidth(m_list->font()));
  const int card = width / columns;
  const QSize grid(card, LessonCard::heightFor(card, m_sentences, m_list->font()));
  if (grid == m_list->gridSize()) return;
  m_list->setGridSize(grid);
  for (int row = 0; row < m_list->count(); ++row) m_list->item(row)->setSizeHint(grid);
  forgetPictures();
}

void LessonChooser::forgetPictures() {
  ++m_look;
  for (int row = 0; row < m_list->count(); ++row)
    m_list->item(row)->setData(Qt::DecorationRole, {});
  drawNextPicture();
}

/// One in sight, if there is one.
QListWidgetItem* LessonChooser::nextWithoutPicture() const {
  QListWidgetItem* next = nullptr;
  const QRect sight = m_list->viewport()->rect();
  for (int row = 0; row < m_list->count(); ++row) {
    QListWidgetItem* item = m_list->item(row);
    if (item->data(Qt::DecorationRole).isValid()) continue;
    if (m_list->visualItemRect(item).intersects(sight)) return item;
    if (!next) next = item;
  }
  return next;
}

void LessonChooser::drawNextPicture() {
  if (!isVisible() || m_painter->isRunning()) return;
  QListWidgetItem* item = nextWithoutPicture();
  if (!item) return;
  const Lesson lesson = lessonNamed(item->data(LessonCard::kName).toString());
  const QSize size = LessonCard::pictureSize(m_list->gridSize().width());
  const auto picture = std::make_shared<QImage>();
  m_painter->start(
      [=, ratio = devicePixelRatioF(), theme = Theme::of(palette())](const core::Progress&) {
        *picture = scenePreview(builtInScene(lesson.name), lesson.pictureTime, size, ratio, theme);
      },
      [this, item, picture, look = m_look] {
        if (look == m_look) item->setData(Qt::DecorationRole, *picture);
        drawNextPicture();
      });
}

void LessonChooser::choose(int row) {
  if (row < 0) return;
  accept();
  emit chosen(m_list->item(row)->data(LessonCard::kName).toString());
}

void LessonChooser::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  layOut();
}

void LessonChooser::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::FontChange) layOut();
  if (event->type() == QEvent::PaletteChange) forgetPictures();
}

void LessonChooser::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  layOut();
  drawNextPicture();
}

}  // namespace ui
