#pragma once

#include <vector>

#include <QObject>
#include <QString>

#include "ui/chart/chart_frame.h"
#include "ui/chart/charted_run.h"
#include "ui/chart/energy_extent.h"
#include "ui/chart/figure_text.h"

class QChart;
class QLineSeries;

namespace ui {

/// Energies of runs as curves in a chart, the same on screen and on paper. Belongs to its
/// chart as a child object.
class EnergyPlot : public QObject {
  Q_OBJECT

 public:
  /// @param chart  takes ownership
  explicit EnergyPlot(QChart* chart);

  void setLook(const ChartLook& look);
  void setTitle(const QString& title, const QString& note);
  /// The time axis reaches at least to there [s]; keeps the first moments of a growing run
  /// from changing the axis all the time.
  void setLeastTime(double time);

  /// The ledgers must outlive the plot or the next call.
  void setRuns(std::vector<ChartedRun> runs);
  const std::vector<ChartedRun>& runs() const { return m_runs; }

  /// Reads the ledgers anew.
  void update();

 private:
  void styleCurves();
  void showScales(const EnergyExtent& extent);
  void showCurves(const EnergyExtent& extent);
  HeadingContent heading(const EnergyExtent& extent) const;
  std::vector<HeadingEntry> legend(const EnergyExtent& extent) const;
  std::vector<HeadingEntry> runEntries() const;
  QString warning(const EnergyExtent& extent) const;

  ChartFrame* m_frame;  // belongs to the chart
  std::vector<ChartedRun> m_runs;
  std::vector<QLineSeries*> m_curves;  // run by run, in the order of energyQuantities()
  QString m_title;
  QString m_note;
  double m_leastTime = 0;
  NiceScale m_energyScale;
  ScaledUnit m_energyUnit;
  ScaledUnit m_timeUnit;
};

}  // namespace ui
