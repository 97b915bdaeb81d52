#pragma once

#include <vector>

#include <QString>

#include "app/sample_clock.h"
#include "core/recording/ledger.h"

namespace core {
class Run;
}

namespace app {

/// The energies of one run up to a moment: all of them for a chart, eleven for a table.
class EnergyHistory {
 public:
  /// @param until  [s], ≥ 0
  explicit EnergyHistory(double until);

  /// Call once before the first step and once after each.
  void record(const core::Run& run);

  const core::Ledger& ledger() const { return m_ledger; }
  /// A short table, one moment a line.
  QString table() const;

 private:
  double m_until;
  SampleClock m_tableClock;
  std::vector<core::EnergySample> m_tableRows;
  core::Ledger m_ledger;
};

}  // namespace app
