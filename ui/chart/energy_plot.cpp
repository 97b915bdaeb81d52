#include "ui/chart/energy_plot.h"

#include <algorithm>
#include <utility>

#include <QChart>
#include <QLineSeries>

#include "ui/chart/curve_points.h"
#include "ui/chart/energy_extent.h"
#include "ui/chart/energy_heading.h"
#include "ui/chart/energy_quantity.h"
#include "ui/chart/energy_scales.h"
#include "ui/chart/run_pen.h"

namespace ui {

namespace {

/// Thinned, in the units of the axes.
std::vector<core::CurvePoint> curveOf(const core::Ledger& ledger, const EnergyQuantity& quantity,
                                      double offset, const EnergyScales& scales, std::size_t most) {
  std::vector<core::CurvePoint> all;
  all.reserve(ledger.samples().size());
  for (const core::EnergySample& sample : ledger.samples()) {
    if (isFinite(sample)) all.push_back({sample.time, quantity.of(sample.energies)});
  }
  std::vector<core::CurvePoint> curve = core::thinned(all, most);
  for (core::CurvePoint& point : curve) {
    point.x /= scales.timeUnit.size;
    point.y = (point.y - offset) / scales.energyUnit.size;
  }
  return curve;
}

}  // namespace

EnergyPlot::EnergyPlot(QChart* chart) : QObject(chart), m_frame(new ChartFrame(chart)) {
  connect(m_frame, &ChartFrame::resized, this, &EnergyPlot::update);
}

void EnergyPlot::setLook(const ChartLook& look) {
  m_frame->setLook(look);
  update();
}

void EnergyPlot::setTitle(const QString& title, const QString& note) {
  m_title = title;
  m_note = note;
}

void EnergyPlot::setLeastTime(double time) {
  m_leastTime = time;
}

void EnergyPlot::setMostPoints(std::size_t most) {
  m_mostPoints = most;
}

void EnergyPlot::setRuns(std::vector<ChartedRun> runs) {
  m_runs = std::move(runs);
  m_frame->removeCurves();
  m_curves.clear();
  for (const ChartedRun& run : m_runs) {
    for (const EnergyQuantity& quantity : energyQuantities()) {
      m_curves.push_back(m_frame->addCurve(quantity.name() + QStringLiteral(", ") + run.name));
    }
  }
  update();
}

void EnergyPlot::update() {
  const EnergyExtent extent = extentOf(m_runs);
  const EnergyScales scales = energyScales(extent, m_leastTime, m_frame->horizontalIntervals(),
                                           m_frame->verticalIntervals());
  HeadingContent heading = energyHeading(m_runs, extent, scales, m_frame->look().theme);
  heading.title = m_title;
  heading.note = m_note;
  m_frame->setHeading(std::move(heading));
  m_frame->setHorizontal(scales.time, tr("Time (%1)").arg(scales.timeUnit.symbol));
  m_frame->setVertical(scales.energy, tr("Energy (%1)").arg(scales.energyUnit.symbol));
  showCurves(extent, scales);
}

void EnergyPlot::showCurves(const EnergyExtent& extent, const EnergyScales& scales) {
  const auto quantities = energyQuantities();
  const auto shown = static_cast<std::size_t>(std::ranges::count(extent.shown, true));
  const std::size_t room = mostPointsPerCurve(shown * m_runs.size(), m_mostPoints);
  // Each point above the scale may be replaced by two, where the curve leaves and returns.
  const std::size_t most = extent.ceiling ? room * 2 / 3 : room;
  for (std::size_t i = 0; i < m_curves.size(); ++i) {
    const std::size_t index = i % quantities.size();
    m_curves[i]->setVisible(extent.shown[index]);
    if (!extent.shown[index]) continue;
    showCurve(i / quantities.size(), quantities[index], most, extent, scales, *m_curves[i]);
  }
}

void EnergyPlot::showCurve(std::size_t run, const EnergyQuantity& quantity, std::size_t most,
                           const EnergyExtent& extent, const EnergyScales& scales,
                           QLineSeries& curve) {
  const double offset = quantity.holdsPotential ? extent.offset : 0;
  const QList<QPointF> points =
      cutToScale(curveOf(*m_runs[run].ledger, quantity, offset, scales, most), scales.energy.lowest,
                 scales.energy.highest);
  const QColor color = m_frame->look().theme.*quantity.color;
  const bool dense = run > 0 && isTooDenseForDashes(points, m_frame->unitSize());
  const QPen pen = dense ? densePen(color) : runPen(color, quantity.width, run);
  if (curve.pen() != pen) curve.setPen(pen);
  curve.replace(points);
}

}  // namespace ui
