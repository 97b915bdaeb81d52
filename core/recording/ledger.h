#pragma once

#include <cstddef>

#include "core/motion/energy.h"
#include "core/recording/series.h"

namespace core {

/// Energies at one moment.
struct EnergySample {
  double time = 0;  ///< [s]
  Energies energies;

  /// What an energy axis must have room for [J].
  double height() const { return energies.accounted(); }
};

/// Energies of a run over time, in bounded memory.
class Ledger : public Series<EnergySample> {
 public:
  /// @param most  samples kept, ≥ 4
  explicit Ledger(std::size_t most = 40000) : Series(most) {}
};

}  // namespace core
