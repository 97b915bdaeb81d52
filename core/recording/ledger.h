#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/motion/energy.h"

namespace core {

/// Energies at one moment.
struct EnergySample {
  double time = 0;  ///< [s]
  Energies energies;
};

/// Energies of a run over time, in bounded memory: when full, every other sample of the
/// whole past is dropped and from then on only every second, fourth, … offered one is kept,
/// so a run of any length is covered evenly. First and latest are always there.
class Ledger {
 public:
  /// @param most  samples kept, ≥ 4
  explicit Ledger(std::size_t most = 40000) : m_most(most) {}

  void append(const EnergySample& sample);
  void clear();
  /// Forgets what came after `time` [s].
  void dropAfter(double time);

  /// In time order.
  std::span<const EnergySample> samples() const { return m_samples; }
  /// Largest accounted energy so far [J]: the top of an energy axis. Samples that are no
  /// longer kept count, until dropAfter() forgets some.
  double highest() const { return m_highest; }

 private:
  void raiseHighest(const EnergySample& sample);
  void thinByHalf();

  std::size_t m_most;
  std::size_t m_stride = 1;      // offered samples per kept one
  std::size_t m_offered = 0;     // since the last kept one
  bool m_latestIsExtra = false;  // the last sample stands only until the next is offered
  double m_highest = 0;
  std::vector<EnergySample> m_samples;
};

}  // namespace core
