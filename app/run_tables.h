#pragma once

#include <span>

#include <QString>

#include "app/csv_output.h"
#include "app/options.h"
#include "app/sample_clock.h"
#include "core/run/event.h"

namespace core {
class Run;
}

namespace app {

/// Trajectory, energies and events of one run as CSV, written while it runs.
class RunTables {
 public:
  explicit RunTables(const SimulateCall& call);

  // Each returns false where it failed and says why in error().
  bool open();
  /// Call once before the first step and once after each.
  bool record(const core::Run& run);
  /// @param run  at its end
  bool finish(const core::Run& run);

  /// One line that names the file; empty if nothing failed.
  QString error() const;

 private:
  void recordRow(const core::Run& run, double time);
  void recordEvents(std::span<const core::Event> events);

  double m_until;
  SampleClock m_clock;
  CsvOutput m_trajectory;
  CsvOutput m_energy;
  CsvOutput m_events;
};

}  // namespace app
