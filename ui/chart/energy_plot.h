#pragma once

#include <limits>
#include <vector>

#include <QObject>
#include <QString>

#include "ui/chart/chart_frame.h"
#include "ui/chart/charted_run.h"

class QChart;
class QLineSeries;

namespace ui {

struct EnergyExtent;
struct EnergyQuantity;
struct EnergyScales;

/// Energies of runs as curves in a chart, the same on screen and on paper. Belongs to its
/// chart as a child object.
class EnergyPlot : public QObject {
  Q_OBJECT

 public:
  /// @param chart  takes ownership
  explicit EnergyPlot(QChart* chart);

  void setLook(const ChartLook& look);
  /// Above the legend; shown from the next update on.
  void setTitle(const QString& title, const QString& note);
  /// The time axis reaches at least to there [s]; keeps the first moments of a growing run
  /// from changing the axis all the time.
  void setLeastTime(double time);
  /// All curves together have at most so many points; without, each has its 2000.
  void setMostPoints(std::size_t most);

  /// The ledgers must outlive the plot or the next call.
  void setRuns(std::vector<ChartedRun> runs);
  const std::vector<ChartedRun>& runs() const { return m_runs; }

  /// Reads the ledgers anew.
  void update();

 private:
  void showCurves(const EnergyExtent& extent, const EnergyScales& scales);
  void showCurve(std::size_t run, const EnergyQuantity& quantity, std::size_t most,
                 const EnergyExtent& extent, const EnergyScales& scales, QLineSeries& curve);

  ChartFrame* m_frame;  // belongs to the chart
  std::vector<ChartedRun> m_runs;
  std::vector<QLineSeries*> m_curves;  // run by run, in the order of energyQuantities()
  QString m_title;
  QString m_note;
  double m_leastTime = 0;
  std::size_t m_mostPoints = std::numeric_limits<std::size_t>::max();
};

}  // namespace ui
