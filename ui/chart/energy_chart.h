#pragma once

#include <vector>

#include <QChartView>

#include "ui/chart/charted_run.h"
#include "ui/style/theme.h"

namespace ui {

/// Energies of one or several runs against time on one scale: kinetic, potential, lost to
/// air, to impacts, to ropes, to friction (the last two only once they are not zero),
/// total, and the total's drift in figures. Draws ledgers; computes no physics.
class EnergyChart : public QChartView {
  Q_OBJECT

 public:
  explicit EnergyChart(QWidget* parent = nullptr);
  ~EnergyChart() override;

  /// Which runs to draw from now on: solid curves for the first, dashed for the second.
  /// The ledgers must outlive the chart or the next call.
  void setRuns(std::vector<ChartedRun> runs);

  /// Redraws from the ledgers; call at most once per frame, it thins and limits itself.
  void refresh();

  /// Colors and fonts; follows the window's palette.
  void setTheme(const Theme& theme);

 private:
  class Content;
  Content* m_content = nullptr;  // child object
};

}  // namespace ui
