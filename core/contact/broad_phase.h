#pragma once

#include <cstdint>
#include <vector>

#include "core/contact/path.h"

namespace core {

/// Uniform grid over boxes, which somebody else holds: which weights may meet at all.
///
/// A box that covers more cells than it is worth is kept in a list of its own and offered
/// to everybody. Moving a weight leaves its old box behind for a while: a query may name
/// weights that are no longer there, never miss one that is. What is left behind is cleared
/// away before it outnumbers what is there, so that a query stays as quick after any number
/// of moves.
class BroadPhase {
 public:
  /// @param boxes  one per weight, to outlive this
  explicit BroadPhase(const std::vector<Box>& boxes) : m_boxes(boxes) {}

  /// Starts anew with the boxes as they are.
  void rebuild();

  /// To be called when that weight's box has changed.
  void move(int weight);

  /// Calls `use(other)` once for each weight whose cells meet those of `box`, in an order
  /// that depends on the boxes alone.
  template <class Use>
  void forEachNear(const Box& box, Use&& use) {
    ++m_round;
    const Cells cells = cellsOf(box);
    for (int row = cells.firstRow; row <= cells.lastRow; ++row)
      for (int column = cells.firstColumn; column <= cells.lastColumn; ++column)
        for (int entry = m_heads[row * m_columns + column]; entry >= 0;
             entry = m_entries[entry].next)
          visit(m_entries[entry].weight, use);
    for (const int weight : m_large) visit(weight, use);
  }

 private:
  struct Cells {
    int firstColumn, lastColumn, firstRow, lastRow;
    /// False for the range no weight is entered in yet.
    bool hold(const Cells& other) const {
      return firstColumn <= other.firstColumn && other.lastColumn <= lastColumn &&
             firstRow <= other.firstRow && other.lastRow <= lastRow;
    }
    int count() const { return (lastColumn - firstColumn + 1) * (lastRow - firstRow + 1); }
  };
  struct Entry {
    int weight;
    int next;
  };

  template <class Use>
  void visit(int weight, Use& use) {
    if (m_seen[weight] == m_round) return;
    m_seen[weight] = m_round;
    use(weight);
  }

  Cells cellsOf(const Box& box) const;
  void chooseCells();
  void enter(int weight);
  std::size_t entryCount() const { return m_entries.size() + m_large.size(); }

  const std::vector<Box>& m_boxes;
  Eigen::Vector2d m_origin{0, 0};
  double m_cell = 1;  // edge of a cell [m]
  int m_columns = 1;
  int m_rows = 1;
  std::vector<int> m_heads;
  std::vector<Entry> m_entries;
  std::vector<Cells> m_entered;  // of each weight: the cells it was entered in last
  std::vector<int> m_large;
  std::size_t m_entriesWhenFilled = 0;
  std::vector<std::uint32_t> m_seen;
  std::uint32_t m_round = 0;
};

}  // namespace core
