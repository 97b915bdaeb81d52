#pragma once

#include <QString>

namespace core {
class Ledger;
}

namespace ui {

/// Writes a run's energies over time as CSV, whole or not at all.
/// @return empty, or what went wrong in words
QString writeLedgerFile(const QString& file, const core::Ledger& ledger);

}  // namespace ui
