#pragma once

#include <vector>

#include <QWidget>

#include "ui/panels/weight_columns.h"
#include "ui/control/words.h"
#include "ui/panels/weights_clipboard.h"

class QAction;
class QTableView;
class QToolBar;

namespace ui {

class MessageBar;
class SceneEditor;
class Selection;
class WeightsModel;

/// All weights in a table: what is typed goes to all selected rows; cells are copied and
/// pasted like those of a spreadsheet. The current row is the selected weight.
class WeightsTable : public QWidget {
  Q_OBJECT

 public:
  WeightsTable(SceneEditor* editor, Selection* selection, QWidget* parent = nullptr);

  /// Buttons for what can be done with the rows, wherever they are laid out.
  QToolBar* buttons() const { return m_buttons; }
  QTableView* view() const { return m_view; }
  /// Lets the keys go to the table from now on.
  void takeKeyboard();

 public slots:
  /// Adds a weight as it is by default, beside the others.
  void addWeight();
  /// Adds a copy of every selected weight, beside the others where there is room.
  void duplicate();
  void remove();
  void copy();
  void paste();
  /// Adds what was copied as new weights.
  void pasteAsNew();
  /// Gives all selected rows what the first of them holds in the selected columns.
  void fillDown();

 signals:
  /// Something went well, in words.
  void done(const QString& message);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void buildView();
  void buildButtons();
  QAction* addButton(const QString& iconName, const QString& words, const QString& tip,
                     const QString& keys, void (WeightsTable::*slot)());
  void fitToFont();
  std::vector<int> selectedRows() const;
  ColumnStretch selectedColumns() const;
  void enter(const QModelIndex& index, const QString& text);
  bool take(PastedScene pasted, const Words& words);
  void pasteAt(const PastePlace& place);
  void append(std::vector<core::Weight> weights, const Words& words);
  void showSelected(int weight);
  void offerWhatCanBeDone();

  SceneEditor* m_editor;
  Selection* m_selection;
  WeightsModel* m_model;
  QTableView* m_view;
  QToolBar* m_buttons;
  MessageBar* m_refusal;
  std::vector<QAction*> m_needRows;  // of no use where nothing is selected
};

}  // namespace ui
