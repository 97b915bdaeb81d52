#pragma once

#include <string>

#include "core/trade/measurement.h"

namespace core {

/// All points as CSV, with a header line; see core/recording/csv.h for the form of numbers.
/// Outcome: "ok", "diverged at TIME", or where a step held more events than can be followed
/// or the tolerance asked for more steps than can be taken,
/// "stopped at TIME", TIME in s.
std::string measurementCsv(const Measurement& measurement);

}  // namespace core
