#include "ui/chart/energy_plot.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QChart>
#include <QLineSeries>
#include <QLocale>

#include "ui/chart/curve_points.h"
#include "ui/chart/energy_quantity.h"

namespace ui {

namespace {

// Between the highest curve and the top of the plot.
constexpr double kHeadroom = 1.04;

Qt::PenStyle lineStyle(std::size_t run) {
  constexpr std::array kStyles = {Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
  return kStyles[run % kStyles.size()];
}

QPen linePen(const QColor& color, double width, std::size_t run) {
  QPen pen(color, width, lineStyle(run));
  pen.setCapStyle(Qt::FlatCap);
  return pen;
}

std::vector<core::CurvePoint> curveOf(const core::Ledger& ledger, const EnergyQuantity& quantity,
                                      double offset) {
  std::vector<core::CurvePoint> curve;
  curve.reserve(ledger.samples().size());
  for (const core::EnergySample& sample : ledger.samples()) {
    if (isFinite(sample)) curve.push_back({sample.time, quantity.of(sample.energies) - offset});
  }
  return curve;
}

double offsetOf(const EnergyQuantity& quantity, const EnergyExtent& extent) {
  return quantity.holdsPotential ? extent.offset : 0;
}

/// What the method got wrong up to the latest sample, in J and in percent of the start.
QString driftText(const core::Ledger& ledger) {
  const auto samples = ledger.samples();
  const auto latest = std::find_if(samples.rbegin(), samples.rend(), isFinite);
  if (latest == samples.rend()) return {};
  const double start = samples.front().energies.accounted();
  const double drift = latest->energies.numericalDrift;
  if (!(start > 0)) return EnergyPlot::tr("drift %1 J").arg(signedFigure(drift));
  return EnergyPlot::tr("drift %1 J (%2 %)")
      .arg(signedFigure(drift), signedFigure(100 * drift / start));
}

NiceScale inUnit(const ScaledUnit& unit, double lowest, double highest, int intervals) {
  return niceScale(lowest / unit.size, highest / unit.size, intervals);
}

}  // namespace

EnergyPlot::EnergyPlot(QChart* chart) : QObject(chart), m_frame(new ChartFrame(chart)) {
  connect(m_frame, &ChartFrame::resized, this, &EnergyPlot::update);
}

void EnergyPlot::setLook(const ChartLook& look) {
  m_frame->setLook(look);
  styleCurves();
  update();
}

void EnergyPlot::setTitle(const QString& title, const QString& note) {
  m_title = title;
  m_note = note;
}

void EnergyPlot::setLeastTime(double time) {
  m_leastTime = time;
}

void EnergyPlot::setRuns(std::vector<ChartedRun> runs) {
  m_runs = std::move(runs);
  m_frame->removeCurves();
  m_curves.clear();
  for (const ChartedRun& run : m_runs) {
    for (const EnergyQuantity& quantity : energyQuantities()) {
      m_curves.push_back(m_frame->addCurve());
      m_curves.back()->setName(quantity.name() + QStringLiteral(", ") + run.name);
    }
  }
  styleCurves();
  update();
}

void EnergyPlot::styleCurves() {
  const auto quantities = energyQuantities();
  for (std::size_t i = 0; i < m_curves.size(); ++i) {
    const EnergyQuantity& quantity = quantities[i % quantities.size()];
    const QColor color = m_frame->look().theme.*quantity.color;
    m_curves[i]->setPen(linePen(color, quantity.width, i / quantities.size()));
  }
}

void EnergyPlot::update() {
  const EnergyExtent extent = extentOf(m_runs);
  showScales(extent);
  m_frame->setHeading(heading(extent));
  showCurves(extent);
}

void EnergyPlot::showScales(const EnergyExtent& extent) {
  const double lastTime = std::max(extent.lastTime, m_leastTime);
  m_timeUnit = lastTime < 0.1 ? scaledUnit(lastTime, tr("s")) : ScaledUnit{1, tr("s")};
  m_frame->setHorizontal(inUnit(m_timeUnit, 0, lastTime, m_frame->horizontalIntervals()),
                         tr("Time (%1)").arg(m_timeUnit.symbol));

  const double highest = extent.ceiling.value_or(extent.highest * kHeadroom);
  m_energyUnit = scaledUnit(highest, tr("J"));
  m_energyScale = inUnit(m_energyUnit, extent.lowest, highest, m_frame->verticalIntervals());
  m_frame->setVertical(m_energyScale, tr("Energy (%1)").arg(m_energyUnit.symbol));
}

void EnergyPlot::showCurves(const EnergyExtent& extent) {
  const auto quantities = energyQuantities();
  const auto shown = static_cast<std::size_t>(std::ranges::count(extent.shown, true));
  const std::size_t room = mostPointsPerCurve(shown * m_runs.size());
  // Each point above the scale may be replaced by two, where the curve leaves and returns.
  const std::size_t most = extent.ceiling ? room * 2 / 3 : room;
  for (std::size_t i = 0; i < m_curves.size(); ++i) {
    const std::size_t index = i % quantities.size();
    m_curves[i]->setVisible(extent.shown[index]);
    if (!extent.shown[index]) continue;
    const core::Ledger& ledger = *m_runs[i / quantities.size()].ledger;
    const double offset = offsetOf(quantities[index], extent);
    std::vector<core::CurvePoint> curve =
        core::thinned(curveOf(ledger, quantities[index], offset), most);
    for (core::CurvePoint& point : curve) {
      point.x /= m_timeUnit.size;
      point.y /= m_energyUnit.size;
    }
    m_curves[i]->replace(cutToScale(curve, m_energyScale.lowest, m_energyScale.highest));
  }
}

HeadingContent EnergyPlot::heading(const EnergyExtent& extent) const {
  return {m_title, m_note, warning(extent), {legend(extent), runEntries()}};
}

std::vector<HeadingEntry> EnergyPlot::legend(const EnergyExtent& extent) const {
  const auto quantities = energyQuantities();
  const QLocale locale;
  std::vector<HeadingEntry> entries;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    if (!extent.shown[i]) continue;
    HeadingEntry entry;
    entry.line = linePen(m_frame->look().theme.*quantities[i].color, quantities[i].width, 0);
    entry.text = quantities[i].name();
    const double offset = offsetOf(quantities[i], extent) / m_energyUnit.size;
    if (offset > 0) {
      entry.text = tr("%1 − %2 %3")
                       .arg(entry.text, locale.toString(offset, 'f', m_energyScale.decimals()),
                            m_energyUnit.symbol);
    }
    entries.push_back(entry);
  }
  return entries;
}

std::vector<HeadingEntry> EnergyPlot::runEntries() const {
  const Theme& theme = m_frame->look().theme;
  std::vector<HeadingEntry> entries;
  for (std::size_t i = 0; i < m_runs.size(); ++i) {
    HeadingEntry entry;
    entry.mark = theme.runs[i % theme.runs.size()];
    entry.markFilled = i == 0;
    entry.line = linePen(theme.text, 2, i);
    entry.text = m_runs[i].name;
    entry.figures = driftText(*m_runs[i].ledger);
    entry.widestFigures = tr("drift %1 J (%1 %)").arg(widestFigure());
    entries.push_back(entry);
  }
  return entries;
}

QString EnergyPlot::warning(const EnergyExtent& extent) const {
  if (!extent.ceiling) return {};
  const QString end = QLocale().toString(m_energyScale.highest, 'f', m_energyScale.decimals());
  QStringList reached;
  for (std::size_t i = 0; i < m_runs.size(); ++i) {
    const double highest = extent.highestOfRun[i];
    if (highest > *extent.ceiling) {
      reached.append(tr("%1 reaches %2 J").arg(m_runs[i].name, figure(highest)));
    }
  }
  return tr("Scale ends at %1 %2: %3.")
      .arg(end, m_energyUnit.symbol, reached.join(QStringLiteral("; ")));
}

}  // namespace ui
