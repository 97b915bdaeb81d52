#include "ui/chart/energy_ledger.h"

#include <array>
#include <span>

#include <QCoreApplication>

#include "core/recording/ledger.h"
#include "ui/chart/energy_figures.h"
#include "ui/chart/energy_quantity.h"
#include "ui/style/theme.h"

namespace ui {

namespace {

using core::Energies;
using core::EnergySample;

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::EnergyChart)
};

/// One entry of the stack: what lies in and below it.
struct Layer {
  std::size_t quantity;  // in energyQuantities()
  double (*top)(const Energies&);
};

// From below: potential energy first, for it alone has a height that counts as zero.
constexpr std::array kLayers = {
    Layer{1, [](const Energies& e) { return e.potential; }},
    Layer{0, [](const Energies& e) { return e.mechanical(); }},
    Layer{2, [](const Energies& e) { return e.mechanical() + e.lostToAir; }},
    Layer{3, [](const Energies& e) { return e.mechanical() + e.lostToAir + e.lostToImpacts; }},
    Layer{4,
          [](const Energies& e) {
            return e.mechanical() + e.lostToAir + e.lostToImpacts + e.lostToRopes;
          }},
    Layer{5, [](const Energies& e) { return e.accounted(); }},
};

std::shared_ptr<const PointSource> energyPoints(const core::Ledger& ledger,
                                                double (*of)(const Energies&)) {
  return pointsOf(ledger.series(), [of](const EnergySample& sample) {
    return core::TimedPoint{sample.time, sample.time, of(sample.energies)};
  });
}

double startEnergy(const Energies& energies) {
  return energies.accounted() - energies.numericalDrift;
}

ChartCurve layerCurve(const core::Ledger& ledger, const Layer& layer, std::size_t run,
                      const Theme& theme) {
  const EnergyQuantity& quantity = energyQuantities()[layer.quantity];
  ChartCurve curve;
  curve.name = quantity.name();
  curve.run = run;
  curve.color = theme.*quantity.color;
  curve.points = energyPoints(ledger, layer.top);
  curve.amounts = energyPoints(ledger, quantity.of);
  curve.quantity = layer.quantity;
  curve.style = run == 0 ? CurveStyle::kBand : CurveStyle::kLine;
  curve.holdsPotential = true;
  return curve;
}

ChartCurve driftCurve(const core::Ledger& ledger, std::size_t run, const Theme& theme) {
  const auto samples = ledger.samples();
  ChartCurve curve;
  curve.name = Words::tr("Numerical drift");
  curve.run = run;
  curve.color = theme.drift;
  curve.points = energyPoints(ledger, [](const Energies& e) { return e.accounted(); });
  curve.amounts = energyPoints(ledger, [](const Energies& e) { return e.numericalDrift; });
  curve.style = CurveStyle::kHatched;
  curve.base = samples.empty() ? 0 : startEnergy(samples.front().energies);
  curve.holdsPotential = true;
  return curve;
}

ChartCurve startCurve(const core::Ledger& ledger, const Theme& theme) {
  ChartCurve curve;
  curve.name = Words::tr("At the start");
  curve.color = theme.total;
  curve.points = energyPoints(ledger, startEnergy);
  curve.holdsPotential = true;
  return curve;
}

}  // namespace

ChartContent energyLedger(const ChartSubject& subject, const Theme& theme) {
  ChartContent content = emptyEnergyContent();
  for (std::size_t run = 0; run < subject.runs.size(); ++run) {
    const core::Ledger& ledger = *subject.runs[run].ledger;
    for (const Layer& layer : kLayers) {
      content.curves.push_back(layerCurve(ledger, layer, run, theme));
    }
    content.curves.push_back(driftCurve(ledger, run, theme));
  }
  if (!subject.runs.empty()) {
    content.curves.push_back(startCurve(*subject.runs.front().ledger, theme));
  }
  return content;
}

}  // namespace ui
