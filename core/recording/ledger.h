#pragma once

#include <cstddef>
#include <span>

#include "core/motion/energy.h"
#include "core/recording/even_series.h"

namespace core {

/// Energies at one moment.
struct EnergySample {
  double time = 0;  ///< [s]
  Energies energies;
};

/// Energies of a run over time, in bounded memory that covers a run of any length evenly.
class Ledger {
 public:
  /// @param most  samples kept, ≥ 4
  explicit Ledger(std::size_t most = 40000) : m_series(most) {}

  void append(const EnergySample& sample);
  void clear();
  /// Forgets what came after `time` [s].
  void dropAfter(double time);

  /// In time order.
  std::span<const EnergySample> samples() const { return m_series.samples(); }
  const EvenSeries<EnergySample>& series() const { return m_series; }
  /// Largest accounted energy so far [J]: the top of an energy axis. Samples that are no
  /// longer kept count, until dropAfter() forgets some.
  double highest() const { return m_highest; }

 private:
  void raiseHighest(const EnergySample& sample);

  EvenSeries<EnergySample> m_series;
  double m_highest = 0;
};

}  // namespace core
