#include "ui/chart/energy_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ui {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Height that counts as zero, found from how potential energy goes up and down.
///
/// It is known only once a swing has turned: falling weights tell nothing yet about how
/// far they will fall.
class PotentialSpan {
 public:
  void beginRun() { m_lowestOfRun = kInfinity; }

  void add(double potential) {
    m_lowestOfRun = std::min(m_lowestOfRun, potential);
    m_lowest = std::min(m_lowest, potential);
    m_highest = std::max(m_highest, potential);
    m_recovered = std::max(m_recovered, potential - m_lowestOfRun);
  }

  /// @param highestOther  of all energies that have no height in them [J]
  double offset(double highestOther) const {
    constexpr double kFarOff = 5;
    const double movement = std::max(m_highest - m_lowest, highestOther);
    const bool turned = movement > 0 && m_recovered > movement / 2;
    return turned && m_lowest > kFarOff * movement ? roundedDown(m_lowest, movement) : 0;
  }

 private:
  static double roundedDown(double value, double movement) {
    const double unit = std::pow(10.0, std::floor(std::log10(movement)));
    return unit * std::floor(value / unit);
  }

  double m_lowestOfRun = kInfinity;
  double m_lowest = kInfinity;
  double m_highest = -kInfinity;
  double m_recovered = 0;
};

/// Highest and lowest of each quantity over all runs.
struct Spans {
  std::array<double, kEnergyQuantityCount> lowest;
  std::array<double, kEnergyQuantityCount> highest;
  PotentialSpan potential;
  std::vector<double> highestTotal;
  double start = 0;
  double lastTime = 0;

  Spans() {
    lowest.fill(kInfinity);
    highest.fill(-kInfinity);
  }

  void beginRun() {
    highestTotal.push_back(-kInfinity);
    potential.beginRun();
  }

  void add(const core::EnergySample& sample) {
    const double total = sample.energies.accounted();
    if (highestTotal.back() == -kInfinity) start = std::max(start, total);
    highestTotal.back() = std::max(highestTotal.back(), total);
    potential.add(sample.energies.potential);

    const auto quantities = energyQuantities();
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      const double value = quantities[i].of(sample.energies);
      lowest[i] = std::min(lowest[i], value);
      highest[i] = std::max(highest[i], value);
    }
    lastTime = std::max(lastTime, sample.time);
  }
};

Spans spansOf(const std::vector<ChartedRun>& runs) {
  Spans spans;
  for (const ChartedRun& run : runs) {
    spans.beginRun();
    for (const core::EnergySample& sample : run.ledger->samples()) {
      if (isFinite(sample)) spans.add(sample);
    }
  }
  return spans;
}

double highestWithoutHeight(const Spans& spans) {
  const auto quantities = energyQuantities();
  double highest = 0;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    if (!quantities[i].holdsPotential) highest = std::max(highest, spans.highest[i]);
  }
  return highest;
}

}  // namespace

EnergyExtent extentOf(const std::vector<ChartedRun>& runs) {
  const Spans spans = spansOf(runs);
  EnergyExtent extent;
  extent.highestOfRun = spans.highestTotal;
  extent.lastTime = spans.lastTime;
  extent.offset = spans.potential.offset(highestWithoutHeight(spans));

  const auto quantities = energyQuantities();
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const double offset = quantities[i].holdsPotential ? extent.offset : 0;
    extent.lowest = std::min(extent.lowest, spans.lowest[i] - offset);
    extent.highest = std::max(extent.highest, spans.highest[i] - offset);
    extent.shown[i] = quantities[i].shownWhenZero || spans.highest[i] > 0;
  }

  const double most = kMostGain * (spans.start - extent.offset);
  if (most > 0 && extent.highest > most) extent.ceiling = most;
  return extent;
}

}  // namespace ui
