#include "ui/panels/weights_clipboard.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QStringList>

#include "core/scene/placing.h"

namespace ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::WeightsClipboard)
};

/// Each is looked at beside all others; more would take long.
constexpr std::size_t kMostPlaced = 200;

/// Thrown where a cell cannot be taken.
struct Refusal {
  QString words;
};

using Cells = std::vector<QStringList>;

/// Lines and tabs apart; in quotes both may stand in a cell, as spreadsheets write it.
Cells cellsIn(const QString& text) {
  Cells rows(1);
  QString cell;
  bool inQuotes = false;
  const auto endCell = [&] { rows.back() << std::exchange(cell, {}).trimmed(); };
  for (qsizetype i = 0; i < text.size(); ++i) {
    const QChar c = text[i];
    if (c == '"' && (inQuotes || cell.isEmpty())) {
      const bool isDoubled = inQuotes && i + 1 < text.size() && text[i + 1] == '"';
      if (isDoubled) cell += text[++i];
      if (!isDoubled) inQuotes = !inQuotes;
    } else if (c == '\t' && !inQuotes) {
      endCell();
    } else if (c == '\n' && !inQuotes) {
      endCell();
      rows.emplace_back();
    } else if (c != '\r') {
      cell += c;
    }
  }
  endCell();
  if (rows.size() > 1 && rows.back() == QStringList{QString()}) rows.pop_back();
  return rows;
}

/// The column that headings begin with; nothing if they are none.
std::optional<int> headedColumn(const QStringList& cells) {
  for (int first = 0; first + cells.size() <= kWeightColumnCount; ++first) {
    bool allMatch = true;
    for (int i = 0; i < cells.size() && allMatch; ++i) {
      const auto column = static_cast<WeightColumn>(first + i);
      const QString cell = cells[i].simplified();
      allMatch = cell == columnHeading(column) || cell == columnName(column);
    }
    if (allMatch) return first;
  }
  return std::nullopt;
}

[[noreturn]] void refuse(std::size_t row, WeightColumn column, const QString& reason) {
  throw Refusal{Words::tr("Weight %1, %2: %3").arg(row + 1).arg(columnName(column), reason)};
}

void put(core::Weight& weight, const core::Room& room, std::size_t row, WeightColumn column,
         const QString& text) {
  if (!hasCell(weight, column)) {
    if (text.isEmpty()) return;
    refuse(row, column,
           weight.rope ? Words::tr("a weight on a rope has none, got “%1”").arg(text)
                       : Words::tr("a weight that hangs on nothing has none, got “%1”").arg(text));
  }
  if (text.isEmpty() && column != WeightColumn::kColor) refuse(row, column, Words::tr("is empty"));
  const QString fault = setCell(weight, room, column, text);
  if (!fault.isEmpty()) refuse(row, column, fault);
}

/// What the weight hangs on comes first: it decides which cells there are.
void putRow(core::Weight& weight, const core::Room& room, std::size_t row, int first,
            const QStringList& cells) {
  const int holding = static_cast<int>(WeightColumn::kHangsOn) - first;
  if (0 <= holding && holding < cells.size())
    put(weight, room, row, WeightColumn::kHangsOn, cells[holding]);
  for (int i = 0; i < cells.size(); ++i)
    if (i != holding) put(weight, room, row, static_cast<WeightColumn>(first + i), cells[i]);
}

bool saysWhere(const core::Weight& weight, int first, int count) {
  const auto x = static_cast<int>(weight.rope ? WeightColumn::kPivotX : WeightColumn::kX);
  return first <= x && x + 1 < first + count;
}

void checkShape(const Cells& cells, int first, std::size_t row) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].size() != cells.front().size()) {
      throw Refusal{Words::tr("Line %1 has another number of columns than the first (%2, not %3).")
                        .arg(i + 1)
                        .arg(cells[i].size())
                        .arg(cells.front().size())};
    }
  }
  if (first + cells.front().size() > kWeightColumnCount) {
    throw Refusal{Words::tr("There are too many columns: %1, and from %2 on the table has %3.")
                      .arg(cells.front().size())
                      .arg(columnName(static_cast<WeightColumn>(first)))
                      .arg(kWeightColumnCount - first)};
  }
  if (row + cells.size() > static_cast<std::size_t>(core::kMostWeights)) {
    throw Refusal{Words::tr("There would be more than %1 weights.").arg(core::kMostWeights)};
  }
}

/// Writes rows of cells into the scene's weights, adding some where they end.
PastedScene written(core::Scene scene, const Cells& cells, std::size_t row, int first) {
  checkShape(cells, first, row);
  const std::size_t before = scene.weights.size();
  core::Weight model = scene.weights.empty() ? core::firstWeight(scene.room) : scene.weights.back();
  model.color.reset();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool isNew = row + i >= before;
    core::Weight weight = isNew ? model : scene.weights[row + i];
    putRow(weight, scene.room, row + i, first, cells[i]);
    if (!isNew) {
      scene.weights[row + i] = weight;
    } else if (saysWhere(weight, first, static_cast<int>(cells[i].size())) ||
               scene.weights.size() >= before + kMostPlaced) {
      scene.weights.push_back(weight);
    } else {
      scene.weights.push_back(core::placedApart(scene, {weight}).front());
    }
  }
  const std::size_t added = scene.weights.size() - before;
  return {std::move(scene), {}, static_cast<int>(cells.size()), static_cast<int>(added)};
}

}  // namespace

QString cellsText(const core::Scene& scene, const std::vector<int>& rows, ColumnStretch columns) {
  QString text;
  const auto addLine = [&](const auto& cellOf) {
    for (int column = columns.first; column <= columns.last; ++column) {
      if (column > columns.first) text += '\t';
      text += cellOf(static_cast<WeightColumn>(column));
    }
    text += '\n';
  };
  if (columns.isAll()) addLine(columnHeading);
  for (const int row : rows) {
    const core::Weight& weight = scene.weights[static_cast<std::size_t>(row)];
    addLine([&](WeightColumn column) { return exactCellText(weight, column); });
  }
  return text;
}

PastedScene withPasted(const core::Scene& scene, const QString& text, const PastePlace& place) {
  if (text.trimmed().isEmpty()) return {{}, Words::tr("The clipboard holds no text.")};
  Cells cells = cellsIn(text);
  const bool isOneValue = cells.size() == 1 && cells.front().size() == 1;
  if (isOneValue && place.rows.size() > 1 && place.columns.first == place.columns.last) {
    const auto column = static_cast<WeightColumn>(place.columns.first);
    return withValue(scene, place.rows, column, cells.front().front());
  }
  int first = cells.front().size() == kWeightColumnCount ? 0 : place.columns.first;
  if (const auto headed = headedColumn(cells.front())) {
    first = *headed;
    cells.erase(cells.begin());
    if (cells.empty()) return {{}, Words::tr("There are only headings.")};
  }
  try {
    return written(scene, cells, static_cast<std::size_t>(place.row), first);
  } catch (const Refusal& refusal) {
    return {{}, refusal.words};
  }
}

PastedScene withValue(const core::Scene& scene, const std::vector<int>& rows, WeightColumn column,
                      const QString& text) {
  PastedScene result{scene, {}};
  for (const int row : rows) {
    core::Weight& weight = result.scene->weights[static_cast<std::size_t>(row)];
    if (!hasCell(weight, column)) continue;
    ++result.rowCount;
    try {
      put(weight, scene.room, static_cast<std::size_t>(row), column, text);
    } catch (const Refusal& refusal) {
      return {{}, refusal.words};
    }
  }
  return result;
}

}  // namespace ui
