#pragma once

#include <string>
#include <string_view>

#include "core/recording/event_log.h"
#include "core/recording/ledger.h"
#include "core/run/run.h"

namespace core {

// CSV after RFC 4180: lines end in CR LF, '.' is the decimal point whatever the locale,
// every number in the shortest form that reads back to the same double, SI units, degrees
// for angles.

/// Header lines, with their line end.
std::string_view trajectoryHeader();
std::string_view energyHeader();
std::string_view eventHeader();

/// Appends one row.
/// @param time  [s]
void appendTrajectoryRow(std::string& csv, double time, int weight, const WeightState& state);
void appendEnergyRow(std::string& csv, double time, const Energies& energies);
void appendEventRow(std::string& csv, const Event& event);

}  // namespace core
