#include "app/run_tables.h"

#include "core/recording/csv.h"
#include "core/run/run.h"

namespace app {

RunTables::RunTables(const SimulateCall& call)
    : m_until(call.until),
      m_clock(call.sample, call.until),
      m_trajectory(call.trajectory, core::trajectoryHeader()),
      m_energy(call.energy, core::energyHeader()),
      m_events(call.events, core::eventHeader()) {}

bool RunTables::open() {
  return m_trajectory.open() && m_energy.open() && m_events.open();
}

bool RunTables::record(const core::Run& run) {
  for (; m_clock.isDue(run.time()); m_clock.next()) {
    recordRow(run, m_clock.moment());
    if (!m_trajectory.flush() || !m_energy.flush()) return false;
  }
  recordEvents(run.stepEvents());
  return m_events.flush();
}

void RunTables::recordRow(const core::Run& run, double time) {
  if (m_trajectory.isWanted()) {
    for (int i = 0; i < run.weightCount(); ++i) {
      core::appendTrajectoryRow(m_trajectory.rows(), time, i, run.weightAt(i, time));
    }
  }
  if (m_energy.isWanted()) {
    core::appendEnergyRow(m_energy.rows(), time, run.energiesAt(time));
  }
}

void RunTables::recordEvents(std::span<const core::Event> events) {
  if (!m_events.isWanted()) return;
  for (const core::Event& event : events) {
    if (event.time <= m_until) core::appendEventRow(m_events.rows(), event);
  }
}

bool RunTables::finish(const core::Run& run) {
  // What happens at the very end belongs to it, though no step follows.
  recordEvents(run.pendingEvents());
  return m_trajectory.finish() && m_energy.finish() && m_events.finish();
}

QString RunTables::error() const {
  for (const CsvOutput* output : {&m_trajectory, &m_energy, &m_events}) {
    if (!output->error().isEmpty()) return output->error();
  }
  return {};
}

}  // namespace app
