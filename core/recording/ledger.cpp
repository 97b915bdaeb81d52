#include "core/recording/ledger.h"

#include <algorithm>
#include <cmath>

namespace core {

void Ledger::append(const EnergySample& sample) {
  if (m_latestIsExtra) m_samples.pop_back();
  m_latestIsExtra = false;
  if (m_samples.size() == m_most) thinByHalf();
  ++m_offered;
  if (m_samples.empty() || m_offered >= m_stride) {
    m_offered = 0;
  } else {
    m_latestIsExtra = true;
  }
  m_samples.push_back(sample);
  raiseHighest(sample);
}

void Ledger::clear() {
  *this = Ledger(m_most);
}

void Ledger::dropAfter(double time) {
  const auto end = std::ranges::upper_bound(m_samples, time, {}, &EnergySample::time);
  if (end == m_samples.end()) return;
  m_samples.erase(end, m_samples.end());
  m_latestIsExtra = false;
  m_offered = 0;
  m_highest = 0;
  std::ranges::for_each(m_samples, [this](const auto& sample) { raiseHighest(sample); });
}

/// Energies too large for a double would leave an axis without numbers.
void Ledger::raiseHighest(const EnergySample& sample) {
  const double energy = sample.energies.accounted();
  if (std::isfinite(energy)) m_highest = std::max(m_highest, energy);
}

/// @pre no extra sample stands at the end
void Ledger::thinByHalf() {
  // What goes with the last sample still counts as offered since the one before it.
  if (m_samples.size() % 2 == 0) m_offered += m_stride;
  for (std::size_t i = 1; 2 * i < m_samples.size(); ++i) m_samples[i] = m_samples[2 * i];
  m_samples.resize((m_samples.size() + 1) / 2);
  m_stride *= 2;
}

}  // namespace core
