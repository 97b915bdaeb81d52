#pragma once

#include <vector>

#include <QWidget>

#include "ui/chart/charted_run.h"

class QComboBox;

namespace ui {

class EnergyChart;
class RunController;

/// The energy chart of all runs, or of a chosen one.
class EnergyPanel : public QWidget {
  Q_OBJECT

 public:
  explicit EnergyPanel(const RunController* controller, QWidget* parent = nullptr);

  /// What the chart shows: the runs' energies and names.
  std::vector<ChartedRun> chosenRuns() const;

  /// Chooses the runs, wherever it is laid out; hidden while there is but one.
  QWidget* chooser() const;

  /// Shows the run with this index; −1: all.
  void choose(int run);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void listRuns();
  void showChosen();
  ChartedRun charted(int run) const;

  const RunController* m_controller;
  QComboBox* m_chooser;
  EnergyChart* m_chart;
};

}  // namespace ui
