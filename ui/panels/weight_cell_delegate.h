#pragma once

#include <functional>

#include <QStyledItemDelegate>

namespace ui {

/// Edits one cell of the weights: words and colors are chosen or typed, numbers typed. What
/// was entered goes to whoever knows which rows it is for, and only if it was touched.
class WeightCellDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using Taker = std::function<void(const QModelIndex&, const QString&)>;

  explicit WeightCellDelegate(Taker take, QObject* parent = nullptr);

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model,
                    const QModelIndex& index) const override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  Taker m_take;
};

}  // namespace ui
