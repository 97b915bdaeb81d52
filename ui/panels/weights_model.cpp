#include "ui/panels/weights_model.h"

#include <QColor>
#include <QGuiApplication>
#include <QPalette>
#include <QPixmap>
#include <QRegularExpression>

#include "core/scene/arrangement.h"
#include "ui/control/problem_words.h"
#include "ui/control/scene_editor.h"
#include "ui/panels/weight_columns.h"
#include "ui/style/theme.h"

namespace ui {
namespace {

constexpr int kWholeWeight = -1;
constexpr int kSwatchSize = 14;  // px
constexpr float kProblemTint = 0.3F;

QColor shownColor(const core::Scene& scene, int row) {
  const core::Color color = core::colorOf(scene, row);
  return {color.red, color.green, color.blue};
}

QPixmap swatch(const QColor& color) {
  QPixmap pixmap(kSwatchSize, kSwatchSize);
  pixmap.fill(color);
  return pixmap;
}

bool isWords(WeightColumn column) {
  return column == WeightColumn::kColor || column == WeightColumn::kHangsOn;
}

}  // namespace

WeightsModel::WeightsModel(const SceneEditor* editor, QObject* parent)
    : QAbstractTableModel(parent), m_editor(editor) {
  connect(editor, &SceneEditor::draftChanged, this, &WeightsModel::showDraft);
  showDraft();
}

int WeightsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : m_rowCount;
}

int WeightsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kWeightColumnCount;
}

/// Rows come and go at the end: they are numbers, not weights.
void WeightsModel::showDraft() {
  const int count = static_cast<int>(m_editor->draft().weights.size());
  findProblems();
  if (count > m_rowCount) {
    beginInsertRows({}, m_rowCount, count - 1);
    m_rowCount = count;
    endInsertRows();
  } else if (count < m_rowCount) {
    beginRemoveRows({}, count, m_rowCount - 1);
    m_rowCount = count;
    endRemoveRows();
  }
  if (count == 0) return;
  emit dataChanged(index(0, 0), index(count - 1, kWeightColumnCount - 1));
  emit headerDataChanged(Qt::Vertical, 0, count - 1);
}

void WeightsModel::findProblems() {
  static const QRegularExpression kPattern(R"(^weights\[(\d+)\]\.?(.*)$)");
  m_problems.clear();
  for (const core::Problem& problem : m_editor->problems()) {
    const auto match = kPattern.match(QString::fromStdString(problem.place));
    if (!match.hasMatch()) continue;
    const int row = match.captured(1).toInt();
    const auto column = columnOfKey(match.captured(2));
    m_problems[{row, column ? static_cast<int>(*column) : kWholeWeight}] = problemWords(problem);
  }
}

QVariant WeightsModel::data(const QModelIndex& index, int role) const {
  const core::Scene& draft = m_editor->draft();
  const auto row = static_cast<std::size_t>(index.row());
  if (row >= draft.weights.size()) return {};
  const auto column = static_cast<WeightColumn>(index.column());
  switch (role) {
    case Qt::DisplayRole:
      return cellText(draft.weights[row], column);
    case Qt::EditRole:
      return exactCellText(draft.weights[row], column);
    case Qt::TextAlignmentRole:
      return static_cast<int>(Qt::AlignVCenter |
                              (isWords(column) ? Qt::AlignLeft : Qt::AlignRight));
    case Qt::DecorationRole:
      return column == WeightColumn::kColor ? swatch(shownColor(draft, index.row())) : QVariant();
    case Qt::ToolTipRole:
      return problemAt(index.row(), index.column());
    case Qt::BackgroundRole: {
      if (problemAt(index.row(), index.column()).isEmpty()) return {};
      QColor tint = Theme::of(QGuiApplication::palette()).drift;
      tint.setAlphaF(kProblemTint);
      return tint;
    }
    default:
      return {};
  }
}

QVariant WeightsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) return rowHeader(section, role);
  if (role == Qt::ToolTipRole) return columnMeaning(static_cast<WeightColumn>(section));
  if (role != Qt::DisplayRole) return {};
  // Below each other, so that columns are no wider than their numbers need.
  const auto column = static_cast<WeightColumn>(section);
  if (column == WeightColumn::kDragCoefficient) return columnName(column).replace(' ', '\n');
  return columnHeading(column).replace(" [", "\n[");
}

QVariant WeightsModel::rowHeader(int row, int role) const {
  const QString problem = problemAt(row, kWholeWeight);
  if (role == Qt::DisplayRole)
    return problem.isEmpty() ? QString::number(row + 1) : tr("%1 !").arg(row + 1);
  if (role == Qt::ToolTipRole) return problem;
  if (role == Qt::TextAlignmentRole) return static_cast<int>(Qt::AlignVCenter | Qt::AlignRight);
  return {};
}

Qt::ItemFlags WeightsModel::flags(const QModelIndex& index) const {
  const core::Scene& draft = m_editor->draft();
  const auto row = static_cast<std::size_t>(index.row());
  if (row >= draft.weights.size()) return Qt::NoItemFlags;
  const bool hasIt = hasCell(draft.weights[row], static_cast<WeightColumn>(index.column()));
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable | (hasIt ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

}  // namespace ui
