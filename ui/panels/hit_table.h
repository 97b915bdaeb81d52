#pragma once

#include <vector>

#include <QTableWidget>

#include "ui/chart/cut_sweep_result.h"

namespace ui {

/// Moments that hit a target, one a row.
class HitTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit HitTable(QWidget* parent = nullptr);

  void setHits(const std::vector<core::Hit>& hits);

 signals:
  /// The user double-clicked a row, or pressed Return on it: its best cut time [s].
  void momentPicked(double cutTime);

 private:
  void addRow(const core::Hit& hit);

  std::vector<double> m_moments;  // row by row
};

}  // namespace ui
