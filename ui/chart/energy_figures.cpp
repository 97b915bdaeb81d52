#include "ui/chart/energy_figures.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QLocale>

#include "ui/chart/chart_scales.h"
#include "ui/chart/energy_extent.h"
#include "ui/chart/figure_text.h"

namespace ui {

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::EnergyChart)
};

}  // namespace

ChartContent emptyEnergyContent() {
  ChartContent content;
  content.horizontal = {Words::tr("Time"), Words::tr("s")};
  content.vertical = {Words::tr("Energy"), Words::tr("J")};
  content.energies = true;
  content.fromZero = true;
  return content;
}

QString driftText(const core::Ledger& ledger) {
  const auto samples = ledger.samples();
  const auto latest = std::find_if(samples.rbegin(), samples.rend(), isFinite);
  if (latest == samples.rend()) return {};

  constexpr double kMostPercent = 1e6;  // more says nothing that the figure in J does not
  const double drift = latest->energies.numericalDrift;
  const double percent = 100 * drift / samples.front().energies.accounted();
  if (!(std::abs(percent) <= kMostPercent)) return Words::tr("drift %1 J").arg(signedFigure(drift));
  return Words::tr("drift %1 J (%2 %)").arg(signedFigure(drift), signedFigure(percent));
}

QString widestDriftText() {
  return Words::tr("drift %1 J (%1 %)").arg(widestFigure());
}

QString ceilingWarning(const std::vector<ChartedRun>& runs, const EnergyExtent& extent,
                       const AxisScale& energy) {
  if (!extent.ceiling) return {};
  QStringList reached;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double highest = extent.highestOfRun[i];
    if (highest > *extent.ceiling) {
      reached.append(Words::tr("%1 reaches %2 J").arg(runs[i].name, figure(highest)));
    }
  }
  const QString end = QLocale().toString(energy.highest, 'f', energy.ticks.decimals());
  return Words::tr("Scale ends at %1 %2: %3.")
      .arg(end, energy.unit.symbol, reached.join(QStringLiteral("; ")));
}

QString offsetText(const EnergyExtent& extent, const AxisScale& energy) {
  if (extent.offset <= 0) return {};
  const QString offset = QLocale().toString(extent.offset / energy.unit.size, 'g', 12);
  return Words::tr(" − %1 %2").arg(offset, energy.unit.symbol);
}

}  // namespace ui
