#include "core/recording/ledger.h"

#include <algorithm>
#include <cmath>

namespace core {

void Ledger::append(const EnergySample& sample) {
  m_series.append(sample);
  raiseHighest(sample);
}

void Ledger::clear() {
  m_series.clear();
  m_highest = 0;
}

void Ledger::dropAfter(double time) {
  if (!m_series.dropAfter(time)) return;
  m_highest = 0;
  std::ranges::for_each(samples(), [this](const auto& sample) { raiseHighest(sample); });
}

/// Energies too large for a double would leave an axis without numbers.
void Ledger::raiseHighest(const EnergySample& sample) {
  const double energy = sample.energies.accounted();
  if (std::isfinite(energy)) m_highest = std::max(m_highest, energy);
}

}  // namespace core
