#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/recording/ledger.h"
#include "ui/chart/charted_run.h"
#include "ui/chart/energy_quantity.h"

namespace ui {

/// What one or several ledgers span, to choose common axes for them. Samples that are not
/// finite count for nothing.
struct EnergyExtent {
  double lastTime = 0;  ///< [s]
  double lowest = 0;    ///< of anything drawn, ≤ 0 [J]
  double highest = 0;   ///< of anything drawn [J]

  /// Taken off potential and total before they are drawn [J]: 0, unless weights move so
  /// high above the floor that their movement would be lost in m g y.
  double offset = 0;

  /// Top of the scale where a run grew out of all proportion [J].
  std::optional<double> ceiling;

  /// Highest total of each run [J].
  std::vector<double> highestOfRun;

  /// Until when each run has at most kMostGain times the energy it began with [s]: what
  /// comes later must not press everything else flat. Infinite where it always has.
  std::vector<double> soundUntil;

  /// Which energyQuantities() have anything to show.
  std::array<bool, kEnergyQuantityCount> shown = {};
};

/// A run that gains more than this many times the energy it began with is drawn up to
/// there: one that diverges must not press all others flat.
inline constexpr double kMostGain = 10;

EnergyExtent extentOf(const std::vector<ChartedRun>& runs);

/// The same for ledgers that grow: each call reads only what is new.
class GrowingEnergyExtent {
 public:
  GrowingEnergyExtent();
  ~GrowingEnergyExtent();
  GrowingEnergyExtent(const GrowingEnergyExtent&) = delete;
  GrowingEnergyExtent& operator=(const GrowingEnergyExtent&) = delete;

  EnergyExtent of(const std::vector<ChartedRun>& runs);

 private:
  class Spans;  // of one run
  std::vector<Spans> m_spans;
};

/// Whether every energy in it is a number.
inline bool isFinite(const core::EnergySample& sample) {
  return std::isfinite(sample.energies.accounted());
}

}  // namespace ui
