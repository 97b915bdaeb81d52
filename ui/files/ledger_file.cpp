#include "ui/files/ledger_file.h"

#include "core/recording/csv.h"
#include "ui/files/output_file.h"

namespace ui {

QString writeLedgerFile(const QString& file, const core::Ledger& ledger) {
  std::string csv(core::energyHeader());
  for (const core::EnergySample& sample : ledger.samples()) {
    core::appendEnergyRow(csv, sample.time, sample.energies);
  }
  OutputFile output;
  output.open(file) && output.write(csv) && output.finish();
  return output.error();
}

}  // namespace ui
