#include "ui/panels/weights_table.h"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QTableView>
#include <QToolBar>
#include <QVBoxLayout>

#include "core/scene/placing.h"
#include "ui/control/scene_editor.h"
#include "ui/control/selection.h"
#include "ui/control/translations.h"
#include "ui/panels/message_bar.h"
#include "ui/panels/weight_cell_delegate.h"
#include "ui/panels/weights_model.h"
#include "ui/style/icons.h"

namespace ui {
namespace {

constexpr int kRowMargin = 8;  // px above and below the words together
constexpr int kColumnMargin = 20;
constexpr QSize kIconSize(16, 16);

/// Keys that move in a table or begin to edit a cell; the window has other uses for them.
bool isTableKey(const QKeyEvent& event) {
  const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
  switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Home:
    case Qt::Key_End:
      return !(modifiers & ~Qt::ShiftModifier);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return !modifiers;
    default:
      break;
  }
  const QString text = event.text();
  return !modifiers && !text.isEmpty() && (text[0].isDigit() || QString("+-.,#").contains(text[0]));
}

}  // namespace

WeightsTable::WeightsTable(SceneEditor* editor, Selection* selection, QWidget* parent)
    : QWidget(parent),
      m_editor(editor),
      m_selection(selection),
      m_model(new WeightsModel(editor, this)),
      m_view(new QTableView),
      m_buttons(new QToolBar),
      m_refusal(new MessageBar(tr("Close"))) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addWidget(m_refusal);
  layout->addWidget(m_view);
  buildView();
  buildButtons();
  connect(m_refusal, &MessageBar::accepted, this, [this] { m_refusal->say({}); });
  connect(editor, &SceneEditor::draftChanged, this, [this] { m_refusal->say({}); });
  connect(selection, &Selection::weightSelected, this, &WeightsTable::showSelected);
  fitToFont();
  offerWhatCanBeDone();
}

void WeightsTable::takeKeyboard() {
  m_view->setFocus();
  if (m_view->selectionModel()->hasSelection() || m_model->rowCount() == 0) return;
  const QModelIndex current = m_view->currentIndex();
  const QModelIndex cell = current.isValid() ? current : m_model->index(0, 0);
  m_view->selectionModel()->setCurrentIndex(cell, QItemSelectionModel::ClearAndSelect);
}

void WeightsTable::buildView() {
  m_view->setModel(m_model);
  m_view->setObjectName("weightsTable");
  m_view->setAccessibleName(tr("Weights table"));
  m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_view->setAlternatingRowColors(true);
  m_view->setWordWrap(false);
  m_view->setFrameShape(QFrame::NoFrame);
  m_view->setTabKeyNavigation(false);
  m_view->setCornerButtonEnabled(true);
  m_view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                          QAbstractItemView::AnyKeyPressed);
  m_view->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  // One height for all: no row has to be looked at to know where another is.
  m_view->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  m_view->horizontalHeader()->setHighlightSections(false);
  m_view->setItemDelegate(new WeightCellDelegate(
      [this](const QModelIndex& index, const QString& text) { enter(index, text); }, this));
  m_view->installEventFilter(this);
  connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &WeightsTable::offerWhatCanBeDone);
  connect(m_view->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) { m_selection->select(current.row()); });
}

void WeightsTable::buildButtons() {
  m_buttons->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_buttons->setIconSize(kIconSize);
  m_view->setContextMenuPolicy(Qt::ActionsContextMenu);
  addButton("add", tr("Add"), tr("Add a weight"), "Ins", &WeightsTable::addWeight);
  m_needRows = {addButton("duplicate", tr("Duplicate"), tr("Add a copy of each selected weight"),
                          "Shift+Ins", &WeightsTable::duplicate),
                addButton("remove", tr("Remove"), tr("Remove the selected weights"), "Del",
                          &WeightsTable::remove),
                addButton("copy", tr("Copy"), tr("Copy the selected cells for a spreadsheet"),
                          "Ctrl+C", &WeightsTable::copy)};
  addButton("paste", tr("Paste"),
            tr("Paste cells, from a spreadsheet too, over those from the "
               "first selected one on"),
            "Ctrl+V", &WeightsTable::paste);
  addButton("", tr("Paste as new"), tr("Add what was copied as new weights"), "Ctrl+Shift+V",
            &WeightsTable::pasteAsNew);
  m_needRows.push_back(addButton("fill-down", tr("Fill down"),
                                 tr("Give all selected rows what the first of them holds"),
                                 "Ctrl+D", &WeightsTable::fillDown));
}

/// @param iconName  empty: in the context menu alone
QAction* WeightsTable::addButton(const QString& iconName, const QString& words, const QString& tip,
                                 const QString& keys, void (WeightsTable::*slot)()) {
  auto* action = new QAction(words, m_view);
  action->setShortcut(QKeySequence(keys));
  action->setShortcutContext(Qt::WidgetShortcut);
  action->setStatusTip(tip);
  action->setToolTip(tr("%1 (%2)").arg(tip, action->shortcut().toString(QKeySequence::NativeText)));
  connect(action, &QAction::triggered, this, slot);
  m_view->addAction(action);
  if (iconName.isEmpty()) return action;
  action->setIcon(icon(iconName));
  m_buttons->addAction(action);
  m_buttons->widgetForAction(action)->setFocusPolicy(Qt::TabFocus);
  return action;
}

void WeightsTable::fitToFont() {
  m_view->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + kRowMargin);
  const int number = fontMetrics().horizontalAdvance(QStringLiteral("−00.0000"));
  for (int column = 0; column < kWeightColumnCount; ++column) {
    const int name = m_view->horizontalHeader()->sectionSizeHint(column);
    const bool isColor = column == static_cast<int>(WeightColumn::kColor);
    const int mark = isColor ? 2 * fontMetrics().height() : 0;
    m_view->setColumnWidth(column, std::max(name, number + mark + kColumnMargin));
  }
}

/// Rising.
std::vector<int> WeightsTable::selectedRows() const {
  std::vector<bool> isSelected(static_cast<std::size_t>(m_model->rowCount()), false);
  for (const QItemSelectionRange& range : m_view->selectionModel()->selection())
    std::fill(isSelected.begin() + range.top(), isSelected.begin() + range.bottom() + 1, true);
  std::vector<int> rows;
  for (std::size_t row = 0; row < isSelected.size(); ++row)
    if (isSelected[row]) rows.push_back(static_cast<int>(row));
  return rows;
}

/// From the first selected column to the last.
ColumnStretch WeightsTable::selectedColumns() const {
  ColumnStretch columns{kWeightColumnCount - 1, 0};
  for (const QItemSelectionRange& range : m_view->selectionModel()->selection()) {
    columns.first = std::min(columns.first, range.left());
    columns.last = std::max(columns.last, range.right());
  }
  return columns.first <= columns.last ? columns : ColumnStretch{};
}

void WeightsTable::enter(const QModelIndex& index, const QString& text) {
  std::vector<int> rows = selectedRows();
  if (!std::ranges::binary_search(rows, index.row())) rows = {index.row()};
  const auto column = static_cast<WeightColumn>(index.column());
  take(withValue(m_editor->draft(), rows, column, text),
       [column] { return tr("change of %1").arg(withinSentence(columnName(column))); });
}

/// Makes it the scene, or says why not.
bool WeightsTable::take(PastedScene pasted, const Words& words) {
  if (!pasted.scene) {
    m_refusal->say(tr("Nothing was changed. %1").arg(pasted.refusal));
    return false;
  }
  m_editor->change([&](core::Scene& draft) { draft = std::move(*pasted.scene); }, words);
  return true;
}

void WeightsTable::addWeight() {
  append({core::firstWeight(m_editor->draft().room)}, [] { return tr("addition of a weight"); });
}

void WeightsTable::duplicate() {
  std::vector<core::Weight> copies;
  for (const int row : selectedRows())
    copies.push_back(m_editor->draft().weights[static_cast<std::size_t>(row)]);
  append(std::move(copies), [] { return tr("duplication of weights"); });
}

/// Adds weights beside the others and selects them.
void WeightsTable::append(std::vector<core::Weight> weights, const Words& words) {
  if (weights.empty()) return;
  const int first = m_model->rowCount();
  const auto edit = [&](core::Scene& draft) {
    for (core::Weight& weight : core::placedApart(draft, std::move(weights)))
      draft.weights.push_back(std::move(weight));
  };
  m_editor->change(edit, words);
  const int column = std::max(m_view->currentIndex().column(), 0);
  m_view->setCurrentIndex(m_model->index(first, column));
  const QItemSelection all(m_model->index(first, 0),
                           m_model->index(m_model->rowCount() - 1, kWeightColumnCount - 1));
  m_view->selectionModel()->select(all, QItemSelectionModel::ClearAndSelect);
}

void WeightsTable::remove() {
  const std::vector<int> rows = selectedRows();
  if (rows.empty()) return;
  const auto edit = [&](core::Scene& draft) {
    std::vector<core::Weight> kept;
    auto gone = rows.begin();
    for (int row = 0; row < static_cast<int>(draft.weights.size()); ++row) {
      const bool goes = gone != rows.end() && *gone == row;
      if (goes) ++gone;
      if (!goes) kept.push_back(draft.weights[static_cast<std::size_t>(row)]);
    }
    draft.weights = std::move(kept);
  };
  m_editor->change(edit, [] { return tr("removal of weights"); });
  const int row = std::min(rows.front(), m_model->rowCount() - 1);
  m_view->selectionModel()->clearSelection();
  m_view->setCurrentIndex(m_model->index(row, std::max(m_view->currentIndex().column(), 0)));
}

void WeightsTable::copy() {
  const std::vector<int> rows = selectedRows();
  if (rows.empty()) return;
  QApplication::clipboard()->setText(cellsText(m_editor->draft(), rows, selectedColumns()));
  emit done(tr("Rows copied: %1").arg(rows.size()));
}

void WeightsTable::paste() {
  const std::vector<int> rows = selectedRows();
  pasteAt({rows, rows.empty() ? 0 : rows.front(), selectedColumns()});
}

void WeightsTable::pasteAsNew() {
  pasteAt({{}, m_model->rowCount(), {}});
}

void WeightsTable::pasteAt(const PastePlace& place) {
  PastedScene pasted = withPasted(m_editor->draft(), QApplication::clipboard()->text(), place);
  const int rows = pasted.rowCount;
  const int added = pasted.addedCount;
  if (!take(std::move(pasted), [] { return tr("pasting"); })) return;
  emit done(added == 0 ? tr("Rows pasted: %1").arg(rows)
                       : tr("Rows pasted: %1; new weights: %2").arg(rows).arg(added));
}

void WeightsTable::fillDown() {
  const std::vector<int> rows = selectedRows();
  if (rows.size() < 2) return;
  const ColumnStretch columns = selectedColumns();
  const auto& source = m_editor->draft().weights[static_cast<std::size_t>(rows.front())];
  PastedScene filled{m_editor->draft(), {}};
  for (int i = columns.first; i <= columns.last && filled.scene; ++i) {
    const auto column = static_cast<WeightColumn>(i);
    if (!hasCell(source, column)) continue;
    filled = withValue(*filled.scene, rows, column, exactCellText(source, column));
  }
  take(std::move(filled), [] { return tr("filling down"); });
}

void WeightsTable::showSelected(int weight) {
  const QModelIndex current = m_view->currentIndex();
  if (weight < 0 || weight == current.row()) return;
  m_view->setCurrentIndex(m_model->index(weight, std::max(current.column(), 0)));
}

void WeightsTable::offerWhatCanBeDone() {
  const bool anySelected = m_view->selectionModel()->hasSelection();
  for (QAction* action : m_needRows) action->setEnabled(anySelected);
}

bool WeightsTable::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
    return QWidget::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool isReturn = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
  if (event->type() == QEvent::ShortcutOverride && isTableKey(*key)) event->accept();
  if (event->type() == QEvent::KeyPress && isReturn) {
    // One that ends the editing of a cell comes here, too.
    const QModelIndex current = m_view->currentIndex();
    if (m_view->hasFocus() && (current.flags() & Qt::ItemIsEditable)) m_view->edit(current);
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void WeightsTable::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) fitToFont();
}

}  // namespace ui
