#include "core/contact/broad_phase.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr int kMostCellsPerBox = 64;

}  // namespace

void BroadPhase::rebuild() {
  chooseCells();
  m_heads.assign(static_cast<std::size_t>(m_columns) * m_rows, -1);
  m_entries.clear();
  m_large.clear();
  m_entered.assign(m_boxes.size(), {0, -1, 0, -1});
  m_seen.assign(m_boxes.size(), 0);
  m_round = 0;
  for (std::size_t i = 0; i < m_boxes.size(); ++i) enter(static_cast<int>(i));
  m_entriesWhenFilled = entryCount();
}

void BroadPhase::move(int weight) {
  enter(weight);
  if (entryCount() > 2 * m_entriesWhenFilled + kMostCellsPerBox) rebuild();
}

void BroadPhase::enter(int weight) {
  const Cells cells = cellsOf(m_boxes[weight]);
  if (m_entered[weight].hold(cells)) return;
  m_entered[weight] = cells;
  if (cells.count() > kMostCellsPerBox) {
    m_large.push_back(weight);
    return;
  }
  for (int row = cells.firstRow; row <= cells.lastRow; ++row)
    for (int column = cells.firstColumn; column <= cells.lastColumn; ++column) {
      int& head = m_heads[row * m_columns + column];
      m_entries.push_back({weight, head});
      head = static_cast<int>(m_entries.size()) - 1;
    }
}

void BroadPhase::chooseCells() {
  m_columns = m_rows = 1;
  if (m_boxes.size() < 8) return;
  Box all = m_boxes.front();
  double edges = 0;
  for (const Box& box : m_boxes) {
    all.low = all.low.cwiseMin(box.low);
    all.high = all.high.cwiseMax(box.high);
    edges += (box.high - box.low).sum() / 2;
  }
  const Eigen::Vector2d extent = all.high - all.low;
  const auto count = static_cast<double>(m_boxes.size());
  // A cell as wide as a mean box keeps both the cells per box and the boxes per cell few;
  // never more cells than twice the weights.
  const double evenCell = std::sqrt(extent.x() * extent.y() / (2 * count));
  const double cell = std::max({edges / count, evenCell, extent.maxCoeff() / (2 * count)});
  if (!(cell > 0) || !std::isfinite(cell)) return;
  m_cell = cell;
  m_origin = all.low;
  m_columns = 1 + static_cast<int>(extent.x() / m_cell);
  m_rows = 1 + static_cast<int>(extent.y() / m_cell);
}

BroadPhase::Cells BroadPhase::cellsOf(const Box& box) const {
  const auto index = [&](double place, double origin, int count) {
    const double cell = (place - origin) / m_cell;
    return static_cast<int>(std::clamp(cell, 0.0, count - 1.0));
  };
  return {index(box.low.x(), m_origin.x(), m_columns), index(box.high.x(), m_origin.x(), m_columns),
          index(box.low.y(), m_origin.y(), m_rows), index(box.high.y(), m_origin.y(), m_rows)};
}

}  // namespace core
