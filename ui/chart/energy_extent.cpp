#include "ui/chart/energy_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ui {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How potential energy went up and down, to find the height that counts as zero.
///
/// It is known only once a swing has turned: falling weights tell nothing yet about how
/// far they will fall.
struct PotentialSpan {
  double lowest = kInfinity;
  double highest = -kInfinity;
  double recovered = 0;  // most that a run rose again

  void add(double potential) {
    lowest = std::min(lowest, potential);
    highest = std::max(highest, potential);
    recovered = std::max(recovered, potential - lowest);
  }

  void add(const PotentialSpan& other) {
    lowest = std::min(lowest, other.lowest);
    highest = std::max(highest, other.highest);
    recovered = std::max(recovered, other.recovered);
  }

  /// @param highestOther  of all energies that have no height in them [J]
  double offset(double highestOther) const {
    constexpr double kFarOff = 5;
    const double movement = std::max(highest - lowest, highestOther);
    const bool turned = movement > 0 && recovered > movement / 2;
    return turned && lowest > kFarOff * movement ? roundedDown(lowest, movement) : 0;
  }

 private:
  static double roundedDown(double value, double movement) {
    const double unit = std::pow(10.0, std::floor(std::log10(movement)));
    return unit * std::floor(value / unit);
  }
};

/// Highest and lowest of each quantity.
struct QuantitySpans {
  std::array<double, kEnergyQuantityCount> lowest;
  std::array<double, kEnergyQuantityCount> highest;

  QuantitySpans() {
    lowest.fill(kInfinity);
    highest.fill(-kInfinity);
  }

  void add(const QuantitySpans& other) {
    for (std::size_t i = 0; i < kEnergyQuantityCount; ++i) {
      lowest[i] = std::min(lowest[i], other.lowest[i]);
      highest[i] = std::max(highest[i], other.highest[i]);
    }
  }

  double highestWithoutHeight() const {
    const auto quantities = energyQuantities();
    double all = 0;
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      if (!quantities[i].holdsPotential) all = std::max(all, highest[i]);
    }
    return all;
  }
};

}  // namespace

/// What the samples of one run that were read so far span.
class GrowingEnergyExtent::Spans {
 public:
  void read(const core::EvenSeries<core::EnergySample>& series) {
    if (m_series != &series || m_revision != series.revision()) {
      *this = Spans();
      m_series = &series;
      m_revision = series.revision();
    }
    for (const core::EnergySample& sample : series.samples().subspan(m_read)) {
      if (isFinite(sample)) add(sample);
    }
    m_read = series.settled();
  }

  QuantitySpans quantities;
  PotentialSpan potential;
  double start = 0;
  double highestTotal = -kInfinity;
  double lastTime = 0;
  double soundUntil = kInfinity;

 private:
  void add(const core::EnergySample& sample) {
    const double total = sample.energies.accounted();
    if (highestTotal == -kInfinity) start = total;
    highestTotal = std::max(highestTotal, total);
    potential.add(sample.energies.potential);
    if (start > 0 && total > kMostGain * start) soundUntil = std::min(soundUntil, sample.time);

    const auto all = energyQuantities();
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double value = all[i].of(sample.energies);
      quantities.lowest[i] = std::min(quantities.lowest[i], value);
      quantities.highest[i] = std::max(quantities.highest[i], value);
    }
    lastTime = std::max(lastTime, sample.time);
  }

  const void* m_series = nullptr;
  std::uint64_t m_revision = 0;
  std::size_t m_read = 0;
};

GrowingEnergyExtent::GrowingEnergyExtent() = default;
GrowingEnergyExtent::~GrowingEnergyExtent() = default;

EnergyExtent GrowingEnergyExtent::of(const std::vector<ChartedRun>& runs) {
  m_spans.resize(runs.size());
  EnergyExtent extent;
  QuantitySpans spans;
  PotentialSpan potential;
  double start = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    Spans& run = m_spans[i];
    run.read(runs[i].ledger->series());
    spans.add(run.quantities);
    potential.add(run.potential);
    start = std::max(start, run.start);
    extent.highestOfRun.push_back(run.highestTotal);
    extent.soundUntil.push_back(run.soundUntil);
    extent.lastTime = std::max(extent.lastTime, run.lastTime);
  }
  extent.offset = potential.offset(spans.highestWithoutHeight());

  const auto quantities = energyQuantities();
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const double offset = quantities[i].holdsPotential ? extent.offset : 0;
    extent.lowest = std::min(extent.lowest, spans.lowest[i] - offset);
    extent.highest = std::max(extent.highest, spans.highest[i] - offset);
    extent.shown[i] = quantities[i].shownWhenZero || spans.highest[i] > 0;
  }

  const double most = kMostGain * (start - extent.offset);
  if (most > 0 && extent.highest > most) extent.ceiling = most;
  return extent;
}

EnergyExtent extentOf(const std::vector<ChartedRun>& runs) {
  return GrowingEnergyExtent().of(runs);
}

}  // namespace ui
