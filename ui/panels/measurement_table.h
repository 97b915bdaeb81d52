#pragma once

#include <vector>

#include <QTableWidget>

#include "core/trade/measurement.h"

namespace ui {

/// All points of a measurement in figures, one a row.
class MeasurementTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit MeasurementTable(QWidget* parent = nullptr);

  void setMeasurement(const core::Measurement& measurement);

  /// So wide that all columns up to the computing time are in sight [px].
  int widthOfFirstColumns() const;

 signals:
  /// The user double-clicked a row, or pressed Return on it.
  void rowPicked(const core::Solver& solver);

 private:
  void addRow(const core::MeasuredPoint& point);

  std::vector<core::Solver> m_solvers;  // row by row
};

}  // namespace ui
