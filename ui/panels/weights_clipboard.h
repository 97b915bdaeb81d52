#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "core/scene/scene.h"
#include "ui/panels/weight_columns.h"

namespace ui {

/// Columns that stand beside each other.
struct ColumnStretch {
  int first = 0;
  int last = kWeightColumnCount - 1;

  bool isAll() const { return first == 0 && last == kWeightColumnCount - 1; }
};

/// Cells as spreadsheets exchange them: tabs between columns, one line a row, decimals as the
/// reader writes them. Whole rows have a line of headings above.
QString cellsText(const core::Scene& scene, const std::vector<int>& rows, ColumnStretch columns);

/// Where cells are pasted.
struct PastePlace {
  std::vector<int> rows;  ///< selected, rising; one value goes to all of them
  int row = 0;            ///< the first row otherwise; the number of weights: new weights
  ColumnStretch columns;  ///< selected; others begin at the first, whole rows and those with
                          ///< headings where they belong
};

/// The scene with the cells in it, or why they cannot be taken.
struct PastedScene {
  std::optional<core::Scene> scene;
  QString refusal;     ///< one sentence that names row and column
  int rowCount = 0;    ///< weights that were written
  int addedCount = 0;  ///< those of them that are new
};

/// Takes all cells or none. Rows beyond the last add weights like the last, which stand beside
/// the others unless the cells say where they are.
PastedScene withPasted(const core::Scene& scene, const QString& text, const PastePlace& place);

/// The scene with this text in a column of these weights; those that have no such thing stay
/// as they are.
PastedScene withValue(const core::Scene& scene, const std::vector<int>& rows, WeightColumn column,
                      const QString& text);

}  // namespace ui
