#include "ui/panels/weight_cell_delegate.h"

#include <QComboBox>
#include <QEvent>
#include <QLineEdit>
#include <QPixmap>

#include "core/scene/arrangement.h"
#include "ui/panels/weight_columns.h"

namespace ui {
namespace {

// What a chooser remembers.
constexpr auto kTouched = "touched";  // something was chosen
constexpr auto kByKey = "byKey";      // it is used by key, not by mouse

constexpr int kOfferedColors = 8;  // those that stay apart for color-blind eyes
constexpr int kSwatchSize = 14;    // px

void offerColors(QComboBox* chooser) {
  core::Weight weight;
  chooser->addItem(cellText(weight, WeightColumn::kColor));
  for (int i = 0; i < kOfferedColors; ++i) {
    weight.color = core::defaultColor(i);
    const QString name = cellText(weight, WeightColumn::kColor);
    QPixmap swatch(kSwatchSize, kSwatchSize);
    swatch.fill(QColor(name));
    chooser->addItem(swatch, name);
  }
  chooser->setEditable(true);
}

}  // namespace

WeightCellDelegate::WeightCellDelegate(Taker take, QObject* parent)
    : QStyledItemDelegate(parent), m_take(std::move(take)) {}

QWidget* WeightCellDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                          const QModelIndex& index) const {
  const auto column = static_cast<WeightColumn>(index.column());
  if (column == WeightColumn::kColor || column == WeightColumn::kHangsOn) {
    auto* chooser = new QComboBox(parent);
    if (column == WeightColumn::kColor) {
      offerColors(chooser);
    } else {
      chooser->addItems(holdings());
    }
    chooser->setAccessibleName(columnName(column));
    auto* self = const_cast<WeightCellDelegate*>(this);
    connect(chooser, &QComboBox::activated, self, [self, chooser] {
      chooser->setProperty(kTouched, true);
      // What the mouse chooses is meant; keys may go on to the next choice.
      if (chooser->property(kByKey).toBool()) return;
      emit self->commitData(chooser);
      emit self->closeEditor(chooser);
    });
    return chooser;
  }
  auto* line = new QLineEdit(parent);
  line->setAlignment(Qt::AlignRight);
  line->setFrame(false);
  line->setAccessibleName(columnHeading(column));
  return line;
}

void WeightCellDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  const QString text = index.data(Qt::EditRole).toString();
  if (auto* chooser = qobject_cast<QComboBox*>(editor)) {
    chooser->setCurrentText(text);
    if (chooser->lineEdit()) chooser->lineEdit()->setModified(false);
  } else {
    static_cast<QLineEdit*>(editor)->setText(text);
  }
}

void WeightCellDelegate::setModelData(QWidget* editor, QAbstractItemModel*,
                                      const QModelIndex& index) const {
  if (const auto* chooser = qobject_cast<QComboBox*>(editor)) {
    const bool isTyped = chooser->lineEdit() && chooser->lineEdit()->isModified();
    if (isTyped || chooser->property(kTouched).toBool()) m_take(index, chooser->currentText());
  } else {
    const auto* line = static_cast<QLineEdit*>(editor);
    if (line->isModified()) m_take(index, line->text());
  }
}

/// While a cell is edited its keys are not the window's.
bool WeightCellDelegate::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return true;
  }
  const bool isKey = event->type() == QEvent::KeyPress;
  if (isKey || event->type() == QEvent::MouseButtonPress) watched->setProperty(kByKey, isKey);
  return QStyledItemDelegate::eventFilter(watched, event);
}

}  // namespace ui
