#pragma once

#include <string>

#include "core/trade/measurement.h"

namespace core {

/// All points as CSV, with a header line; see core/recording/csv.h for the form of numbers.
/// Outcome: "ok", or "diverged at TIME" with the last good moment [s], whether numbers, events
/// or an adaptive method's steps got out of hand.
std::string measurementCsv(const Measurement& measurement);

}  // namespace core
