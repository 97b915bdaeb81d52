#pragma once

#include <QAbstractTableModel>
#include <QHash>
#include <QString>

#include "core/scene/scene.h"

namespace ui {

class SceneEditor;

/// The weights of the editor's draft as a table, one a row, for a view that asks only for the
/// rows it shows. Changes go through the panel, which knows what is selected.
class WeightsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit WeightsModel(const SceneEditor* editor, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 private:
  void showDraft();
  void findProblems();
  QString problemAt(int row, int column) const { return m_problems.value({row, column}); }
  QVariant rowHeader(int row, int role) const;

  const SceneEditor* m_editor;
  int m_rowCount = 0;
  /// In words, by row and column; column −1: of the weight as a whole.
  QHash<QPair<int, int>, QString> m_problems;
};

}  // namespace ui
