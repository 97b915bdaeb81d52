#pragma once

#include <QString>

namespace core {
struct Measurement;
}

namespace app {

/// The short table: each method's order, what it takes to reach 10⁻³ m and 10⁻⁶ m, and a
/// sentence that says what was found.
QString measureTable(const core::Measurement& measurement);

}  // namespace app
