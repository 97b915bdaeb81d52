#include "ui/chart/energy_heading.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QLocale>

#include "ui/chart/energy_extent.h"
#include "ui/chart/energy_quantity.h"
#include "ui/chart/energy_scales.h"
#include "ui/chart/figure_text.h"
#include "ui/chart/run_pen.h"

namespace ui {

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::EnergyChart)
};

/// What the method got wrong up to the latest sample, in J and in percent of the start.
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

std::vector<HeadingEntry> legend(const EnergyExtent& extent, const EnergyScales& scales,
                                 const Theme& theme) {
  const auto quantities = energyQuantities();
  std::vector<HeadingEntry> entries;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const EnergyQuantity& quantity = quantities[i];
    if (!extent.shown[i]) continue;
    HeadingEntry entry;
    entry.line = runPen(theme.*quantity.color, quantity.width, 0);
    entry.text = quantity.name();
    if (extent.offset > 0 && quantity.holdsPotential) {
      const QString offset = QLocale().toString(extent.offset / scales.energyUnit.size, 'g', 12);
      entry.text = Words::tr("%1 − %2 %3").arg(entry.text, offset, scales.energyUnit.symbol);
    }
    entries.push_back(entry);
  }
  return entries;
}

std::vector<HeadingEntry> runEntries(const std::vector<ChartedRun>& runs, const Theme& theme) {
  constexpr double kLineWidth = 2;
  std::vector<HeadingEntry> entries;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    HeadingEntry entry;
    entry.mark = theme.runs[i % theme.runs.size()];
    entry.markFilled = i == 0;
    entry.line = runPen(theme.text, kLineWidth, i);
    entry.text = runs[i].name;
    entry.figures = driftText(*runs[i].ledger);
    entry.widestFigures = Words::tr("drift %1 J (%1 %)").arg(widestFigure());
    entries.push_back(entry);
  }
  return entries;
}

QString warning(const std::vector<ChartedRun>& runs, const EnergyExtent& extent,
                const EnergyScales& scales) {
  if (!extent.ceiling) return {};
  QStringList reached;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double highest = extent.highestOfRun[i];
    if (highest > *extent.ceiling) {
      reached.append(Words::tr("%1 reaches %2 J").arg(runs[i].name, figure(highest)));
    }
  }
  const QString end = QLocale().toString(scales.energy.highest, 'f', scales.energy.decimals());
  return Words::tr("Scale ends at %1 %2: %3.")
      .arg(end, scales.energyUnit.symbol, reached.join(QStringLiteral("; ")));
}

}  // namespace

HeadingContent energyHeading(const std::vector<ChartedRun>& runs, const EnergyExtent& extent,
                             const EnergyScales& scales, const Theme& theme) {
  HeadingContent content;
  content.legend = legend(extent, scales, theme);
  content.runs = runEntries(runs, theme);
  content.warning = warning(runs, extent, scales);
  return content;
}

}  // namespace ui
