#include "ui/chart/energy_over_time.h"

#include "core/recording/ledger.h"
#include "ui/chart/energy_figures.h"
#include "ui/chart/energy_quantity.h"
#include "ui/style/theme.h"

namespace ui {

namespace {

ChartCurve curveOf(const core::Ledger& ledger, std::size_t index, const Theme& theme) {
  const EnergyQuantity& quantity = energyQuantities()[index];
  ChartCurve curve;
  curve.name = quantity.name();
  curve.color = theme.*quantity.color;
  curve.width = quantity.width;
  curve.holdsPotential = quantity.holdsPotential;
  curve.quantity = index;
  curve.points = pointsOf(ledger.series(), [of = quantity.of](const core::EnergySample& sample) {
    return core::TimedPoint{sample.time, sample.time, of(sample.energies)};
  });
  return curve;
}

}  // namespace

ChartContent energyOverTime(const ChartSubject& subject, const Theme& theme) {
  ChartContent content = emptyEnergyContent();
  for (std::size_t run = 0; run < subject.runs.size(); ++run) {
    for (std::size_t i = 0; i < kEnergyQuantityCount; ++i) {
      content.curves.push_back(curveOf(*subject.runs[run].ledger, i, theme));
      content.curves.back().run = run;
    }
  }
  return content;
}

}  // namespace ui
