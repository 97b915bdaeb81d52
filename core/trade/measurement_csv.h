#pragma once

#include <string>

#include "core/trade/measurement.h"

namespace core {

/// All points as CSV, with a header line; see core/recording/csv.h for the form of numbers.
/// Outcome: "ok", "diverged at TIME", or where one step held more events than can be followed,
/// "stopped at TIME", TIME in s.
std::string measurementCsv(const Measurement& measurement);

}  // namespace core
